// SPDX-License-Identifier: Apache-2.0
// lobe features: what a scene's kernel contains, and why; and what the rest would cost it.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/arm_options.h"
#include "app/command.h"
#include "app/numbers.h"
#include "app/scene_options.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/signals.h"
#include "build/features.h"
#include "study/bench/feature_costs_report.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    CommonOptions common;
    SceneOptions scene;
    CostPlan plan;
    bool measure = false;
};

void add_options(CLI::App& verb, Options& o) {
    add_common_options(verb, o.common);
    add_scene_options(verb, o.scene);
    CLI::Option* measure = verb.add_flag(
        "--measure", o.measure, "compile and render it with each part that is left out, too");
    verb.add_option("--repeats", o.plan.repeats, "pairs of timed renders of each (10)")
        ->transform(whole_number(2, 1000))
        ->needs(measure)
        ->type_name("NUMBER");
    verb.add_option("--compiles", o.plan.compiles, "cold compilations of each (3)")
        ->transform(whole_number(1, 1000))
        ->needs(measure)
        ->type_name("NUMBER");
    verb.footer(
        "--measure takes the scene's film and 16 samples a pixel, unless --resolution or --spp\n"
        "say otherwise. A device that others use meanwhile is measured wrongly.");
}

Json describe(const Scene& scene, const FeatureSet& features, bool text) {
    Json json = {{"features", Json::array()}};
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
    return json;
}

bool stop() { return stop_signal() != 0; }

Json list_features(const Options& o, const Scene& scene) {
    return describe(scene, o.scene.features == "all" ? all_features() : derive_features(scene),
                    o.common.json != "-");
}

// Nothing if a signal asked to stop.
std::optional<Json> measure(const Options& o, KernelText& kernels) {
    if (o.scene.features == "all")
        throw Error(ExitCode::usage, "--measure has nothing to add to --features all");
    install_signal_handlers();
    const Device device = open_device(o.common.device);
    const auto parts = read_arm(device, kernels, o.scene, o.common);
    if (!parts) return {};
    Json json = list_features(o, parts->scene);
    CostPlan plan = o.plan;
    plan.samples = o.scene.spp.value_or(plan.samples);
    const auto costs =
        measure_feature_costs(device, kernels, parts->scene, parts->pack, plan, stop);
    if (!costs) return {};
    if (o.common.json != "-") std::printf("\n%s", to_text(*costs, device.info(), plan).c_str());
    json["measured"] = to_json(*costs, device.info(), plan);
    return json;
}

int run(const Options& o) {
    set_quiet(o.common.quiet);
    if (!o.common.json.empty() && o.common.json != "-") check_writable(o.common.json);
    KernelText kernels = open_kernels(o.common);
    const std::optional<Json> json =
        o.measure ? measure(o, kernels) : list_features(o, read_scene_for(o.scene, kernels));
    if (!json) return stop_exit_code();
    if (!o.common.json.empty()) write_json(o.common.json, json->dump(2) + "\n");
    return 0;
}

}  // namespace

Command add_features_command(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("features", "what a scene's kernel contains, and why");
    auto options = std::make_shared<Options>();
    add_options(*verb, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
