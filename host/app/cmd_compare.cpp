// SPDX-License-Identifier: Apache-2.0
// lobe compare: which of two ways to render is better, at equal time and at equal samples.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>

#include "app/arm_options.h"
#include "app/command.h"
#include "app/numbers.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/signals.h"
#include "report/image_io.h"
#include "study/comparison_page.h"

namespace lobe {
namespace {

constexpr std::uint32_t usual_seeds = 20;

struct Options {
    CommonOptions common;
    SceneOptions scene;
    std::vector<std::string> pair, scenes;
    std::string a, b, csv, html, by = "time", expect;
    std::optional<std::uint32_t> reference_samples;
    ComparisonPlan plan;
    bool longer = false;
    std::vector<std::string> command;
};

void add_arm_options(CLI::App& verb, Options& o) {
    add_scene_options(verb, o.scene);
    verb.remove_option(verb.get_option("scene"));
    verb.add_option("scene", o.pair, "A's scene file and B's, if it is another")
        ->expected(1, 2)
        ->type_name("SCENE_A [SCENE_B]");
    verb.add_option("--scenes", o.scenes, "several scenes, each rendered by A and by B")
        ->type_name("SCENE...");
    verb.add_option("--a", o.a, "scene options of A alone")->type_name("\"OPTIONS\"");
    verb.add_option("--b", o.b, "scene options of B alone, e.g. \"--max-depth 3\"")
        ->type_name("\"OPTIONS\"");
}

void add_options(CLI::App& verb, Options& o) {
    add_common_options(verb, o.common);
    add_arm_options(verb, o);
    verb.add_option("--seeds", o.plan.seeds, "runs of each, paired by their seeds (20)")
        ->transform(whole_number(least_seeds, 100000))
        ->type_name("NUMBER");
    verb.add_option("--seed", o.plan.first_seed, "the first seed (1)")
        ->transform(whole_number(0, std::uint64_t{1} << 61))
        ->type_name("NUMBER");
    verb.add_flag("--own-seeds", o.plan.own_seeds, "B has other seeds than A");
    verb.add_option("--time", o.plan.base_seconds,
                    "shortest time to compare at (what A takes for --spp samples, 8)")
        ->check(real_number(1e-6, 1e6, "from 1e-6 to 1e6"))
        ->type_name("SECONDS");
    verb.add_flag("--long", o.longer, "compare at 512 samples too");
    verb.add_option("--reference-spp", o.reference_samples,
                    "samples of the references (16 times the most compared)")
        ->transform(whole_number(2, 1u << 30))
        ->type_name("NUMBER");
    verb.add_option("--by", o.by, "which table the last sentence is of (time)")
        ->check(CLI::IsMember({"time", "samples"}));
    verb.add_option("--expect", o.expect, "exit with 8 unless A has this verdict")
        ->check(CLI::IsMember({"win", "loss", "tie"}));
    verb.add_option("--csv", o.csv, "write a line for each run")->type_name("FILE");
    verb.add_option("--html", o.html, "write a page with verdicts, charts and tables")
        ->type_name("FILE");
}

// What both arms render, scene by scene.
std::vector<std::pair<std::string, std::string>> scene_pairs(const Options& o) {
    const std::string hint = "lobe compare SCENE_A [SCENE_B], or --scenes SCENE...";
    if (o.pair.empty() == o.scenes.empty())
        throw Error(ExitCode::usage,
                    o.pair.empty() ? "a scene is missing" : "scenes are given in two ways", "",
                    hint);
    if (!o.pair.empty()) return {{o.pair.front(), o.pair.back()}};
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string& scene : o.scenes) pairs.emplace_back(scene, scene);
    return pairs;
}

ComparisonPlan plan_of(const Options& o) {
    ComparisonPlan plan = o.plan;
    if (o.longer) plan.samples.push_back(512);
    if (o.scene.spp) plan.base_samples = even_samples(*o.scene.spp);
    const double most =
        std::max<double>(plan.samples.back(), plan.times.back() * plan.base_samples);
    plan.reference_samples =
        o.reference_samples.value_or(static_cast<std::uint32_t>(std::min(16 * most, 0x1p30)));
    if (plan.seeds < usual_seeds)
        warn(std::to_string(plan.seeds) + " seeds are few: intervals of fewer than " +
             std::to_string(usual_seeds) + " lean on errors that vary as normal deviates do");
    return plan;
}

// What one scene's comparison needs, from the options to the references.
class Bench {
  public:
    Bench(const Options& o, const ComparisonPlan& plan, const Device& device)
        : o_(o), plan_(plan), device_(device) {}

    // Nothing if a signal asked to stop.
    std::optional<SceneComparison> compare(const SceneOptions& a, const SceneOptions& b) {
        KernelText kernels_a = open_kernels(o_.common), kernels_b = kernels_a;
        const auto arm_a = open("A", "--a", o_.a, kernels_a, a);
        const auto arm_b = arm_a ? open("B", "--b", o_.b, kernels_b, b) : nullptr;
        if (!arm_b) return {};
        const auto reference_a = reference(kernels_a, *arm_a);
        if (!reference_a) return {};
        const bool same = arm_a->content_hash() == arm_b->content_hash();
        const auto reference_b = same ? reference_a : reference(kernels_b, *arm_b);
        if (!reference_b) return {};
        auto comparison =
            run_comparison({*arm_a, *reference_a}, {*arm_b, *reference_b}, plan_, stop);
        if (!comparison) return {};
        comparison->a.scene = a.path;
        comparison->a.options = o_.a;
        comparison->b.scene = b.path;
        comparison->b.options = o_.b;
        for (const Arm* arm : {arm_a.get(), arm_b.get()}) arm->keep_program();
        return comparison;
    }

  private:
    std::unique_ptr<Arm> open(const std::string& name, const std::string& option,
                              const std::string& text, KernelText& kernels,
                              const SceneOptions& options) {
        try {
            return open_arm(name, device_, kernels, options, o_.common);
        } catch (const Error& error) {
            if (error.code() != ExitCode::usage || text.empty()) throw;
            throw in_option(option, error);
        }
    }

    static bool stop() { return stop_signal() != 0; }

    std::optional<Reference> reference(const KernelText& kernels, const Arm& arm) {
        return reference_of(device_, kernels, arm, plan_.reference_samples, images_, stop);
    }

    const Options& o_;
    const ComparisonPlan& plan_;
    const Device& device_;
    ImageIo images_;
};

void write(const ComparisonReport& report, const Options& o) {
    if (o.common.json != "-" && !o.common.quiet) std::fputs(to_text(report).c_str(), stdout);
    if (!o.common.json.empty()) write_json(o.common.json, to_json(report).dump(2) + "\n");
    if (!o.csv.empty()) write_file(o.csv, to_csv(report));
    if (o.html.empty()) return;
    ImageIo images;
    write_file(o.html, to_html(comparison_page(report), images));
}

// 8 where another verdict was expected.
int exit_code(const ComparisonReport& report, const std::string& expected) {
    if (expected.empty()) return 0;
    const Verdict verdict = headline(report).verdict;
    std::string found = to_text(verdict);
    std::transform(found.begin(), found.end(), found.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    if (found == expected) return 0;
    throw Error(ExitCode::comparison, "expected '" + expected + "', found '" + found + "'", "",
                verdict_sentence(report));
}

int run(const Options& o) {
    set_quiet(o.common.quiet);
    install_signal_handlers();
    for (const std::string* file : {&o.common.json, &o.csv, &o.html})
        if (!file->empty() && *file != "-") check_writable(*file);
    const auto pairs = scene_pairs(o);
    const SceneOptions a = arm_options(o.scene, "--a", o.a), b = arm_options(o.scene, "--b", o.b);
    ComparisonReport report;
    report.version = LOBE_VERSION;
    report.command = o.command;
    report.plan = plan_of(o);
    report.by_time = o.by == "time";
    const Device device = open_device(o.common.device);
    report.device = device.info();
    Bench bench(o, report.plan, device);
    for (const auto& [path_a, path_b] : pairs) {
        SceneOptions scene_a = a, scene_b = b;
        scene_a.path = path_a;
        scene_b.path = path_b;
        auto comparison = bench.compare(scene_a, scene_b);
        if (!comparison) return stop_exit_code();
        report.scenes.push_back(std::move(*comparison));
    }
    judge_report(report);
    write(report, o);
    return exit_code(report, o.expect);
}

}  // namespace

Command add_compare_command(CLI::App& app, const std::vector<std::string>& command_line) {
    CLI::App* verb = app.add_subcommand(
        "compare", "which of two ways to render has less error, at equal time and equal samples");
    auto options = std::make_shared<Options>();
    options->command = command_line;
    add_options(*verb, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
