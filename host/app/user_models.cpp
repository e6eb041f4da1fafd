// SPDX-License-Identifier: Apache-2.0
#include "app/user_models.h"

#include "base/error.h"
#include "lab/trial/trial.h"
#include "scene/user_model.h"

namespace lobe {

void add_user_models(KernelText& kernels, const std::vector<std::string>& files) {
    for (const std::string& file : files) {
        const std::vector<BrdfTable> models = read_brdf_tables(kernels);
        if (find_user_model(models, file)) continue;
        const UserModel model = read_user_model(file, models);
        kernels.add(model.table.file, model.text);
    }
}

void add_user_files(KernelText& kernels, std::vector<std::string>& words) {
    for (std::string& word : words) {
        if (word.find_first_of("./") == std::string::npos) continue;
        add_user_models(kernels, {word});
        word = find_user_model(read_brdf_tables(kernels), word)->name;
    }
}

void check_trust(const Scene& scene, bool trusted) {
    if (trusted || scene.models.empty()) return;
    const UserModel& model = scene.models.front();
    throw Error(ExitCode::scene, "the scene brings a kernel of its own, " + model.table.file,
                model.where,
                "a kernel is a program that runs with your rights: read it, then give --brdf " +
                    model.table.file + " or --trust-scene-kernels");
}

bool try_user_models(const Device& device, const KernelText& kernels,
                     const std::vector<BrdfTable>& models, const CommonOptions& options) {
    TrialOptions trial;
    trial.kernel_folder = options.kernel_folder;
    trial.version = LOBE_VERSION;
    trial.seconds = trial_seconds();
    for (const BrdfTable& model : models)
        if (model.own && !try_model(device, kernels, model, trial)) return false;
    return true;
}

}  // namespace lobe
