// SPDX-License-Identifier: Apache-2.0
// lobe paper: the table of Ro and Song (2019), measured again; and a verdict on each of its claims.
#include <cstdio>
#include <limits>
#include <memory>

#include "app/command.h"
#include "app/numbers.h"
#include "app/own_scenes.h"
#include "app/scene_options.h"
#include "base/files.h"
#include "base/log.h"
#include "base/signals.h"
#include "base/timer.h"
#include "report/image_io.h"
#include "study/paper/matching.h"
#include "study/paper/page.h"

namespace lobe {
namespace {

struct Options {
    CommonOptions common;
    SceneOptions scene;
    std::vector<std::string> types;
    std::optional<std::uint32_t> runs, reference_samples;
    std::uint64_t first_seed = 1;
    std::string csv, html;
    bool quick = false;
    std::vector<std::string> command;
};

void add_scene(CLI::App& verb, SceneOptions& o) {
    verb.add_option("scene", o.path, "a pbrt scene file (lobe's own showpiece)")
        ->type_name("SCENE");
    verb.add_option("--resolution", o.resolution, "film size (700x700)")->type_name("WxH");
    verb.add_option("--spp", o.spp, "samples a pixel of each run (8)")
        ->transform(whole_number(1, 1u << 20))
        ->type_name("NUMBER");
    verb.add_option("--max-depth", o.max_depth, "most scattering events of a path")
        ->transform(whole_number(0, 1u << 20))
        ->type_name("NUMBER");
    verb.add_option("--n", o.replace_n, "the rational model's n (the material's own, else 100)")
        ->check(real_number(0, std::numeric_limits<double>::max(), "above 0"))
        ->type_name("NUMBER");
    verb.add_option("--dialect", o.dialect, "of the scene file")
        ->check(CLI::IsMember({"auto", "v3", "v4"}));
    verb.add_flag("--lenient", o.lenient,
                  "warn of unknown directives and parameters instead of failing");
}

void add_options(CLI::App& verb, Options& o) {
    add_common_options(verb, o.common);
    add_scene(verb, o.scene);
    verb.add_option("--replace", o.types,
                    "materials that wear the models; may be repeated (plastic and rational)")
        ->type_name("TYPE");
    verb.add_option("--runs", o.runs, "of everything, each with a seed of its own (10)")
        ->transform(whole_number(1, 100000))
        ->type_name("NUMBER");
    verb.add_option("--reference-spp", o.reference_samples,
                    "samples a pixel of the references (256)")
        ->transform(whole_number(2, 1u << 30))
        ->type_name("NUMBER");
    verb.add_option("--seed", o.first_seed, "the first seed (1)")
        ->transform(whole_number(0, std::uint64_t{1} << 61))
        ->type_name("NUMBER");
    verb.add_flag("--quick", o.quick, "256x256, 8 runs, references of 128 samples");
    verb.add_option("--csv", o.csv, "write a line for each run")->type_name("FILE");
    verb.add_option("--html", o.html, "write a page with tables, claims and pictures")
        ->type_name("FILE");
}

// What --quick and the defaults leave open.
SceneOptions scene_options(const Options& o) {
    SceneOptions scene = o.scene;
    if (scene.path.empty()) scene.path = own_scene("showpiece/showpiece.pbrt");
    if (scene.resolution.empty()) scene.resolution = o.quick ? "256x256" : "700x700";
    scene.replace_n.reset();  // of --replace TYPE=MODEL, which this verb does without
    return scene;
}

PaperPlan plan_of(const Options& o) {
    PaperPlan plan;
    plan.samples = o.scene.spp.value_or(8);
    plan.runs = o.runs.value_or(o.quick ? 8 : 10);
    plan.reference_samples = o.reference_samples.value_or(o.quick ? 128 : 256);
    plan.first_seed = o.first_seed;
    plan.keep_pictures = !o.html.empty();
    return plan;
}

void write(const PaperReport& report, const Options& o, ImageIo& images) {
    if (o.common.json != "-" && !o.common.quiet) std::fputs(to_text(report).c_str(), stdout);
    if (!o.common.json.empty()) write_json(o.common.json, to_json(report).dump(2) + "\n");
    if (!o.csv.empty()) write_file(o.csv, to_csv(report));
    if (!o.html.empty()) write_file(o.html, to_html(page_of(report), images));
}

int run(const Options& o) {
    set_quiet(o.common.quiet);
    install_signal_handlers();
    for (const std::string* file : {&o.common.json, &o.csv, &o.html})
        if (!file->empty() && *file != "-") check_writable(*file);
    const auto stop = [] { return stop_signal() != 0; };
    const Stopwatch total;
    KernelText kernels = open_kernels(o.common);
    const SceneOptions options = scene_options(o);
    Stopwatch watch;
    const Scene scene = read_scene_for(options, kernels);
    const double parse_seconds = watch.seconds();
    const std::vector<BrdfTable> models = read_brdf_tables(kernels);
    const Device device = open_device(o.common.device);
    ImageIo images;

    PaperReport report;
    report.version = LOBE_VERSION;
    report.command = o.command;
    report.scene = scene.path;
    report.scene_hash = scene.hash;
    report.device = device.info();
    report.plan = plan_of(o);
    report.quick = o.quick;
    report.replaced = o.types.empty() ? std::vector<std::string>{"plastic", "rational"} : o.types;
    const LobeMeasure measure = measured_on(device, kernels);
    const std::vector<Wearer> wearers =
        find_wearers(scene, models, report.replaced, o.scene.replace_n, measure);
    report.claims = judge_model_claims(lobe_values_on(device, kernels));
    const std::vector<ModelSetting> settings = paper_settings(wearers, measure);
    report.experiment = run_paper({device, kernels, models, scene, parse_seconds, images},
                                  report.plan, wearers, settings, stop);
    if (report.experiment.rounds > 0) report.findings = findings_of(report.experiment);
    for (const Claim& claim : judge_experiment_claims(report.experiment, report.findings))
        report.claims.push_back(claim);
    report.total_seconds = total.seconds();
    write(report, o, images);
    return report.experiment.stopped ? stop_exit_code() : 0;
}

}  // namespace

Command add_paper_command(CLI::App& app, const std::vector<std::string>& command_line) {
    CLI::App* verb = app.add_subcommand(
        "paper", "the paper's table: rational, Phong and modified Phong, and its claims judged");
    auto options = std::make_shared<Options>();
    options->command = command_line;
    add_options(*verb, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
