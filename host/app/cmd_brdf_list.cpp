// SPDX-License-Identifier: Apache-2.0
// lobe brdf list: the models there are.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/brdf_command.h"
#include "base/log.h"

namespace lobe {
namespace {

const char* kind_name(BrdfParameterKind kind) {
    static const char* const names[] = {"color", "number", "integer", "choice", "table"};
    return names[static_cast<int>(kind)];
}

nlohmann::ordered_json to_json(const BrdfParameter& p) {
    nlohmann::ordered_json json = {{"name", p.name}, {"kind", kind_name(p.kind)}};
    if (p.kind == BrdfParameterKind::choice) {
        json["default"] = p.choices[static_cast<std::size_t>(p.standard)];
        json["choices"] = p.choices;
    } else if (p.kind != BrdfParameterKind::table) {
        json["default"] = p.standard;
        json["lowest"] = p.lowest;
        json["highest"] = std::isinf(p.highest) ? nlohmann::ordered_json("inf")
                                                : nlohmann::ordered_json(p.highest);
    }
    json["meaning"] = p.meaning;
    return json;
}

int run(const CommonOptions& options) {
    set_quiet(options.quiet);
    auto json = nlohmann::ordered_json::array();
    std::size_t width = 0;
    const std::vector<BrdfTable> models = read_brdf_tables(open_kernels(options));
    for (const BrdfTable& model : models) width = std::max(width, model.name.size());
    for (const BrdfTable& model : models) {
        auto parameters = nlohmann::ordered_json::array();
        std::string names;
        for (const BrdfParameter& p : model.parameters) {
            parameters.push_back(to_json(p));
            names += (names.empty() ? "" : " ") + p.name;
        }
        json.push_back({{"name", model.name},
                        {"title", model.title()},
                        {"file", model.file},
                        {"parameters", parameters}});
        if (options.json != "-")
            std::printf("%-*s  %s\n%*s  %s\n", static_cast<int>(width), model.name.c_str(),
                        model.title().c_str(), static_cast<int>(width), "", names.c_str());
    }
    if (!options.json.empty()) write_json(options.json, json.dump(2) + "\n");
    return 0;
}

}  // namespace

Command add_brdf_list(CLI::App& verb) {
    CLI::App* list = verb.add_subcommand("list", "the models there are, with their parameters");
    auto options = std::make_shared<CommonOptions>();
    add_common_options(*list, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
