// SPDX-License-Identifier: Apache-2.0
#include "app/lab_options.h"

#include "app/user_models.h"
#include "base/log.h"
#include "base/signals.h"

namespace lobe {

void add_lab_options(CLI::App& verb, LabOptions& options) {
    verb.add_option("models", options.models, "names of models, files of your own, or all")
        ->type_name("NAME|FILE|all");
    verb.add_option("--set", options.settings,
                    "a parameter's value, of one model or of all that have it; may be repeated")
        ->type_name("[MODEL.]NAME=VALUE");
    add_common_options(verb, options.common);
}

std::optional<Lab> open_lab(const LabOptions& options, const std::vector<std::string>& more) {
    set_quiet(options.common.quiet);
    install_signal_handlers();
    KernelText kernels = open_kernels(options.common);
    std::vector<std::string> names = options.models;
    names.insert(names.end(), more.begin(), more.end());
    add_user_files(kernels, names);
    const std::vector<BrdfTable> models = read_brdf_tables(kernels);
    std::vector<BrdfTable> chosen;
    for (const std::string& name : names) {
        if (name == "all")
            chosen.insert(chosen.end(), models.begin(), models.end());
        else
            chosen.push_back(find_brdf(models, name));
    }
    std::vector<Setting> settings;
    for (const std::string& text : options.settings) settings.push_back(parse_setting(text));
    check_settings(chosen, settings);
    std::vector<Subject> subjects;
    for (const BrdfTable& model : chosen) subjects.push_back(set_up(model, settings));
    Device device = open_device(options.common.device);
    if (!try_user_models(device, kernels, chosen, options.common)) return std::nullopt;
    return Lab{std::move(kernels), models, std::move(subjects), std::move(device)};
}

std::string named_for(const std::vector<std::string>& words, const std::string& model) {
    for (const std::string& word : words) {
        const auto dot = word.find('.');
        if (dot == std::string::npos) return word;
        if (word.substr(0, dot) == model) return word.substr(dot + 1);
    }
    return "";
}

}  // namespace lobe
