// SPDX-License-Identifier: Apache-2.0
// lobe converge: how the error of a scene falls with samples and with time.
#include <cstdio>
#include <memory>

#include "app/arm_options.h"
#include "app/command.h"
#include "app/numbers.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/signals.h"
#include "report/image_io.h"
#include "study/convergence_page.h"

namespace lobe {
namespace {

struct Options {
    CommonOptions common;
    SceneOptions scene;
    std::vector<std::string> paths;
    ConvergencePlan plan;
    std::optional<std::uint32_t> reference_samples;
    std::string reference, csv, html, target = "1%";
    std::vector<std::string> command;
    bool no_mask = false, cold = false;
};

void add_scenes(CLI::App& verb, Options& o) {
    add_scene_options(verb, o.scene);
    verb.remove_option(verb.get_option("scene"));
    verb.remove_option(verb.get_option("--spp"));  // the experiment's own choice
    verb.add_option("scene", o.paths, "pbrt scene files, version 3 or 4")
        ->required()
        ->type_name("SCENE...");
}

void add_reference(CLI::App& verb, Options& o) {
    auto* samples = verb.add_option("--reference-spp", o.reference_samples,
                                    "samples of the reference (100 times the most, but no more "
                                    "than all renders together)");
    samples->transform(whole_number(2, 1u << 30))->type_name("NUMBER");
    verb.add_option("--reference", o.reference, "a reference of your own, an EXR of one scene")
        ->type_name("FILE.exr")
        ->excludes(samples);
    verb.add_flag(
        "--no-mask", o.no_mask,
        "compare the pixels in which a light is seen directly, and their neighbours, too");
}

void add_options(CLI::App& verb, Options& o) {
    add_common_options(verb, o.common);
    add_scenes(verb, o);
    verb.add_option("--from", o.plan.first, "samples a pixel of the first level (4)")
        ->transform(whole_number(2, 1u << 20))
        ->type_name("NUMBER");
    verb.add_option("--doublings", o.plan.levels, "levels, each of twice the samples (8)")
        ->transform(whole_number(3, 24))
        ->type_name("NUMBER");
    verb.add_option("--seeds", o.plan.seeds, "independent renders of each level (16)")
        ->transform(whole_number(3, 100000))
        ->type_name("NUMBER");
    verb.add_option("--seed", o.plan.first_seed, "the first seed (0)")
        ->transform(whole_number(0, std::uint64_t{1} << 61))
        ->type_name("NUMBER");
    add_reference(verb, o);
    verb.add_option("--target", o.target, "relative error to tell the time to (1%)")
        ->type_name("PART|PERCENT%");
    verb.add_flag("--cold", o.cold, "measure a compilation that no cache can shorten");
    verb.add_option("--csv", o.csv, "write a line for each render")->type_name("FILE");
    verb.add_option("--html", o.html, "write a page with charts, tables and the reference")
        ->type_name("FILE");
}

// "1%" or "0.01".
double parse_target(const std::string& text) {
    double value = 0;
    char end = 0, more = 0;
    const int read = std::sscanf(text.c_str(), "%lf%c%c", &value, &end, &more);
    if (read == 2 && end == '%') value /= 100;
    if ((read != 1 && !(read == 2 && end == '%')) || !(value > 0 && value < 1))
        throw Error(ExitCode::usage, "--target '" + text + "' is not understood", "",
                    "write a relative error, as 1% or 0.01");
    return value;
}

ConvergencePlan plan_of(const Options& o) {
    ConvergencePlan plan = o.plan;
    plan.mask = !o.no_mask;
    plan.target = parse_target(o.target);
    if (static_cast<double>(plan.first) * (std::uint64_t{1} << (plan.levels - 1)) > 0x1p30)
        throw Error(ExitCode::usage, "--from and --doublings lead to more than 2^30 samples", "",
                    "the last level has FROM times 2^(DOUBLINGS - 1)");
    if (plan.first % 2)
        throw Error(ExitCode::usage, "--from " + std::to_string(plan.first) + " is odd", "",
                    "samples form two halves of one size: give an even number");
    if (plan.seeds < 8)
        warn(std::to_string(plan.seeds) + " seeds are few: the intervals are rough");
    return plan;
}

bool stop() { return stop_signal() != 0; }

class Bench {
  public:
    Bench(const Options& o, const ConvergencePlan& plan, const Device& device)
        : o_(o), plan_(plan), device_(device) {}

    // Nothing if a signal asked to stop before there was anything to tell.
    std::optional<ConvergenceReport> measure(const std::string& path) {
        SceneOptions scene = o_.scene;
        scene.path = path;
        KernelText kernels = open_kernels(o_.common);
        const auto arm = open_arm(path, device_, kernels, scene, o_.common);
        if (!arm) return {};
        const auto reference = this->reference(kernels, *arm);
        if (!reference) return {};
        ConvergenceReport report = measure_convergence(*arm, *reference, plan_, stop);
        report.device = device_.info();
        report.compile_again = arm->compile_again(Caches::all);
        if (o_.cold) report.compile_cold = arm->compile_again(Caches::none);
        arm->keep_program();
        return report;
    }

  private:
    std::optional<Reference> reference(const KernelText& kernels, Arm& arm) {
        if (o_.reference.empty())
            return reference_of(device_, kernels, arm,
                                o_.reference_samples.value_or(plan_.reference_samples()), images_,
                                stop);
        Reference own = read_reference(o_.reference, arm.width(), arm.height(), images_);
        if (!own.has_mask) {  // asked of a render in its place
            ArmRun run = arm.run(reference_seed_bit + 1, 64, stop);
            if (run.stopped) return {};
            own.masked = widened(run.picture.sees_light, arm.width());
        }
        return own;
    }

    const Options& o_;
    const ConvergencePlan& plan_;
    const Device& device_;
    ImageIo images_;
};

void write(const ConvergenceResults& results, const Options& o, ImageIo& images) {
    if (o.common.json != "-" && !o.common.quiet) {
        for (const ConvergenceReport& report : results.scenes)
            std::printf("%s\n", to_text(report).c_str());
        if (results.scenes.size() > 1) std::printf("%s", summary_text(results.scenes).c_str());
    }
    if (!o.common.json.empty()) write_json(o.common.json, to_json(results).dump(2) + "\n");
    if (!o.csv.empty()) write_file(o.csv, to_csv(results));
    if (!o.html.empty()) write_file(o.html, to_html(convergence_page(results), images));
}

int run(const Options& o) {
    set_quiet(o.common.quiet);
    install_signal_handlers();
    for (const std::string* file : {&o.common.json, &o.csv, &o.html})
        if (!file->empty() && *file != "-") check_writable(*file);
    const ConvergencePlan plan = plan_of(o);
    const Device device = open_device(o.common.device);
    ConvergenceResults results;
    results.version = LOBE_VERSION;
    results.command = o.command;
    Bench bench(o, plan, device);
    for (const std::string& path : o.paths) {
        auto report = bench.measure(path);
        if (!report) break;
        for (const std::string& warning : report->warnings) warn(warning, path);
        results.scenes.push_back(std::move(*report));
        if (stop_signal()) break;
    }
    ImageIo images;
    if (!results.scenes.empty()) write(results, o, images);
    return stop_signal() ? stop_exit_code() : 0;
}

}  // namespace

Command add_converge_command(CLI::App& app, const std::vector<std::string>& command_line) {
    CLI::App* verb =
        app.add_subcommand("converge", "how the error of a scene falls with samples and with time");
    auto options = std::make_shared<Options>();
    options->command = command_line;
    add_options(*verb, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
