// SPDX-License-Identifier: Apache-2.0
// lobe brdf trial: what lobe starts in a process of its own to run a user's model for the first
// time. No verb for people: its output is for the process that waits for it.
#include <memory>

#include "app/brdf_command.h"
#include "app/user_models.h"
#include "cl/device.h"
#include "lab/trial/trial.h"
#include "scene/user_model.h"

namespace lobe {
namespace {

struct Options {
    CommonOptions common;
    std::string file;
};

int run(const Options& options) {
    KernelText kernels = open_kernels(options.common);
    add_user_models(kernels, {options.file});
    const std::vector<BrdfTable> models = read_brdf_tables(kernels);
    const Device device = open_device(options.common.device);
    return serve_trial(device, kernels, *find_user_model(models, options.file), LOBE_VERSION);
}

}  // namespace

Command add_brdf_trial(CLI::App& verb) {
    CLI::App* trial = verb.add_subcommand("trial", "");
    trial->group("");  // not in the help
    auto options = std::make_shared<Options>();
    add_common_options(*trial, options->common);
    trial->add_option("file", options->file, "")->required()->type_name("FILE");
    return [options] { return run(*options); };
}

}  // namespace lobe
