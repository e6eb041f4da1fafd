// SPDX-License-Identifier: Apache-2.0
// lobe brdf: the laboratory of reflectance models.
#include "app/brdf_command.h"
#include "base/error.h"

namespace lobe {

Command add_brdf_command(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("brdf", "the laboratory of reflectance models");
    verb->require_subcommand(1);
    const std::vector<std::pair<std::string, Command>> commands = {
        {"list", add_brdf_list(*verb)}, {"check", add_brdf_check(*verb)},
        {"new", add_brdf_new(*verb)},   {"table", add_brdf_table(*verb)},
        {"plot", add_brdf_plot(*verb)}, {"doc", add_brdf_doc(*verb)},
        {"fit", add_brdf_fit(*verb)},   {"trial", add_brdf_trial(*verb)},
    };
    return [verb, commands] {
        for (const auto& [name, command] : commands)
            if (verb->got_subcommand(name)) return command();
        return static_cast<int>(ExitCode::usage);
    };
}

const BrdfTable& find_brdf(const std::vector<BrdfTable>& models, const std::string& name) {
    std::vector<std::string> names;
    for (const BrdfTable& table : models) {
        if (table.name == name) return table;
        names.push_back(table.name);
    }
    const std::string near = nearest_name(name, names);
    throw Error(ExitCode::usage, "there is no model '" + name + "'", "",
                near.empty() ? "lobe brdf list names them all" : "did you mean '" + near + "'?");
}

}  // namespace lobe
