// SPDX-License-Identifier: Apache-2.0
// lobe features: what a scene's kernel contains, and why.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/scene_options.h"
#include "base/log.h"
#include "build/features.h"

namespace lobe {
namespace {

struct Options {
    CommonOptions common;
    SceneOptions scene;
};

int run(const Options& options) {
    set_quiet(options.common.quiet);
    KernelText kernels = open_kernels(options.common);
    const Scene scene = read_scene_for(options.scene, kernels);
    const FeatureSet features =
        options.scene.features == "all" ? all_features() : derive_features(scene);
    nlohmann::ordered_json json = {{"features", nlohmann::ordered_json::array()}};
    const bool text = options.common.json != "-";
    for (const FeatureState& f : features) {
        json["features"].push_back(
            {{"name", f.name}, {"meaning", f.meaning}, {"in", f.in}, {"reason", f.reason}});
        if (text)
            std::printf("%-3s  %-16s %s\n", f.in ? "in" : "out", f.name.c_str(), f.reason.c_str());
    }
    json["brdfs"] = models_in_use(scene);
    if (text) {
        std::printf("in   models          ");
        for (const std::string& model : models_in_use(scene)) std::printf(" %s", model.c_str());
        std::printf("\n");
    }
    if (!options.common.json.empty()) write_json(options.common.json, json.dump(2) + "\n");
    return 0;
}

}  // namespace

Command add_features_command(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("features", "what a scene's kernel contains, and why");
    auto options = std::make_shared<Options>();
    add_common_options(*verb, options->common);
    add_scene_options(*verb, options->scene);
    return [options] { return run(*options); };
}

}  // namespace lobe
