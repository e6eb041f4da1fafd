// SPDX-License-Identifier: Apache-2.0
// lobe bench: what a device does with standard scenes, to be held against other devices.
#include <cstdio>
#include <memory>

#include "app/arm_options.h"
#include "app/command.h"
#include "app/numbers.h"
#include "app/own_scenes.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/memory_peak.h"
#include "base/signals.h"
#include "report/image_io.h"
#include "study/bench/bench_page.h"
#include "study/bench/bench_report.h"

namespace lobe {
namespace {

const std::vector<std::string> standard_scenes = {"cornell/cornell.pbrt", "spheres/rational.pbrt",
                                                  "mis/mis.pbrt", "showpiece/showpiece.pbrt"};

struct Options {
    CommonOptions common;
    std::vector<std::string> paths, against, command;
    std::string resolution = "512x512";
    BenchPlan plan;
    std::string html;
    bool quick = false, growth = false;
};

void add_options(CLI::App& verb, Options& o) {
    add_common_options(verb, o.common);
    verb.add_option("scene", o.paths, "pbrt scene files (lobe's own four)")->type_name("SCENE...");
    verb.add_option("--resolution", o.resolution, "film size of every scene (512x512)")
        ->type_name("WxH");
    verb.add_option("--spp", o.plan.samples, "samples a pixel of each timed render (16)")
        ->transform(whole_number(2, 1u << 20))
        ->type_name("NUMBER");
    verb.add_option("--repeats", o.plan.repeats, "timed renders, and passes over the rays (5)")
        ->transform(whole_number(2, 1000))
        ->type_name("NUMBER");
    verb.add_option("--rays", o.plan.rays.rays, "camera rays of a pass (1048576)")
        ->transform(whole_number(8, 1u << 26))
        ->type_name("NUMBER");
    verb.add_flag("--quick", o.quick, "64x64, 8 samples, 4096 rays, 2 repeats: for slow devices");
    verb.add_flag(
        "--growth", o.growth,
        "also how time and memory grow with triangles, lights, film and samples: minutes");
    verb.add_option("--html", o.html, "write a page with tables and plots")->type_name("FILE");
    verb.add_option("--compare", o.against, "no run: two reports side by side")
        ->expected(2)
        ->type_name("A.json B.json");
    verb.footer(
        "Times are medians with the spread of one repeat; the first pass of each is not\n"
        "counted. A device that others use meanwhile is measured wrongly.");
}

BenchPlan plan_of(const Options& o) {
    BenchPlan plan = o.plan;
    if (o.quick) {
        plan.samples = 8;
        plan.repeats = 2;
        plan.rays.rays = 4096;
    }
    plan.rays.repeats = plan.repeats;
    return plan;
}

nlohmann::ordered_json read_report(const std::string& file) {
    const auto json = nlohmann::ordered_json::parse(read_file(file), nullptr, false);
    if (json.is_discarded()) throw Error(ExitCode::comparison, "the file is no JSON", file);
    return json;
}

int compare(const Options& o) {
    const auto a = read_report(o.against[0]), b = read_report(o.against[1]);
    std::printf("%s", comparison_text(o.against[0], a, o.against[1], b).c_str());
    return 0;
}

bool stop() { return stop_signal() != 0; }

int run(const Options& o) {
    set_quiet(o.common.quiet);
    if (!o.against.empty()) return compare(o);
    install_signal_handlers();
    for (const std::string& file : {o.common.json, o.html})
        if (!file.empty() && file != "-") check_writable(file);
    const Device device = open_device(o.common.device);
    BenchReport report;
    report.version = LOBE_VERSION;
    report.device = device.info();
    report.plan = plan_of(o);
    report.command = o.command;
    const std::vector<std::string>& names = o.paths.empty() ? standard_scenes : o.paths;
    for (const std::string& name : names) {
        if (stop()) break;
        SceneOptions scene;
        scene.path = o.paths.empty() ? own_scene(name) : name;
        scene.resolution = o.quick ? "64x64" : o.resolution;
        KernelText kernels = open_kernels(o.common);
        const auto arm = open_arm(name, device, kernels, scene, o.common);
        if (!arm) break;
        auto figures = bench_scene(device, kernels, *arm, report.plan, stop);
        if (!figures) break;
        report.scenes.push_back(std::move(*figures));
    }
    report.host_bytes = memory_peak();
    if (report.scenes.empty()) return stop_exit_code();
    if (o.growth && !stop())
        report.growth = measure_growth(device, open_kernels(o.common),
                                       o.quick ? short_growth() : whole_growth(), stop);
    if (o.common.json != "-" && !o.common.quiet) std::printf("%s", to_text(report).c_str());
    if (!o.common.json.empty()) write_json(o.common.json, to_json(report).dump(2) + "\n");
    ImageIo images;
    if (!o.html.empty()) write_file(o.html, to_html(bench_page(report), images));
    return stop_signal() ? stop_exit_code() : 0;
}

}  // namespace

Command add_bench_command(CLI::App& app, const std::vector<std::string>& command_line) {
    CLI::App* verb = app.add_subcommand("bench", "what a device does with standard scenes");
    auto options = std::make_shared<Options>();
    options->command = command_line;
    add_options(*verb, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
