// SPDX-License-Identifier: Apache-2.0
// lobe brdf check: whether models are what they say, on the device that renders them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/brdf_command.h"
#include "app/user_models.h"
#include "base/error.h"
#include "base/log.h"
#include "base/signals.h"
#include "base/timer.h"
#include "cl/device.h"
#include "lab/check/check.h"
#include "lab/parameter_sweep.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    CommonOptions common;
    std::vector<std::string> models;
    std::string grid = "full";
    std::uint64_t seed = 1;
    bool extremes = false;
};

const char* verdict(const Finding& f) {
    return !f.skipped.empty() && f.tests == 0 ? "skip" : f.passed ? "ok" : "FAIL";
}

// What the check saw, in a few words: the least p-value or the worst figure, and where.
std::string seen(const Finding& f) {
    if (f.tests == 0) return f.skipped.empty() ? "nothing to test" : f.skipped;
    std::string text = f.p.empty()
                           ? "worst " + short_number(f.worst) +
                                 (std::isnan(f.limit) ? "" : ", limit " + short_number(f.limit))
                           : "least p " + short_number(f.least_p());
    text += " of " + std::to_string(f.tests);
    if (!f.where.empty()) text += " (" + f.where + ")";
    return f.note.empty() ? text : text + "; " + f.note;
}

void print(const ModelReport& report, bool details) {
    std::printf(
        "%-4s  %-18s %3zu parameter sets, albedo up to %.4f, weight deviation up to %s, "
        "%.1f s\n",
        report.passed() ? "ok" : "FAIL", report.model.c_str(), report.sets, report.largest_albedo,
        short_number(report.largest_weight_deviation).c_str(), report.compile_s + report.check_s);
    for (const Finding& f : report.findings)
        if (details || !f.passed)
            std::printf("      %-4s  %-12s  %s\n", verdict(f), f.check.c_str(), seen(f).c_str());
}

Json to_json(const Finding& f) {
    Json json = {{"check", f.check}, {"verdict", verdict(f)}, {"tests", f.tests}};
    if (!f.p.empty()) {
        json["least_p"] = f.least_p();
        json["p"] = f.p;
    } else if (f.tests) {
        json["worst"] = f.worst;
        if (!std::isnan(f.limit)) json["limit"] = f.limit;
    }
    if (!f.where.empty()) json["where"] = f.where;
    if (!f.note.empty()) json["note"] = f.note;
    if (!f.skipped.empty()) json["skipped"] = f.skipped;
    return json;
}

Json to_json(const ModelReport& report) {
    Json json = {{"model", report.model},
                 {"passed", report.passed()},
                 {"parameter_sets", report.sets},
                 {"largest_albedo", report.largest_albedo},
                 {"largest_weight_deviation", report.largest_weight_deviation},
                 {"compile_s", report.compile_s},
                 {"check_s", report.check_s},
                 {"checks", Json::array()}};
    for (const Finding& f : report.findings) json["checks"].push_back(to_json(f));
    return json;
}

std::vector<const BrdfTable*> chosen(const std::vector<BrdfTable>& models,
                                     const std::vector<std::string>& names) {
    std::vector<const BrdfTable*> tables;
    for (const std::string& name : names) {
        if (name == "all")
            for (const BrdfTable& table : models) tables.push_back(&table);
        else
            tables.push_back(&find_brdf(models, name));
    }
    return tables;
}

// A user's own models run in a process of their own before they run here.
bool try_own(const std::vector<const BrdfTable*>& tables, const KernelText& kernels,
             const CommonOptions& options) {
    std::vector<BrdfTable> own;
    for (const BrdfTable* table : tables)
        if (table->own) own.push_back(*table);
    return own.empty() || try_user_models(open_device(options.device), kernels, own, options);
}

int run(const Options& options) {
    set_quiet(options.common.quiet);
    const Stopwatch watch;
    KernelText kernels = open_kernels(options.common);
    std::vector<std::string> names = options.models;
    add_user_files(kernels, names);
    const std::vector<BrdfTable> models = read_brdf_tables(kernels);
    const std::vector<const BrdfTable*> tables = chosen(models, names);
    if (!try_own(tables, kernels, options.common)) return stop_exit_code();
    if (options.extremes)
        return run_brdf_extremes(options.common, kernels, tables, options.grid == "reduced");
    const Device device = open_device(options.common.device);
    CheckOptions check;
    check.seed = options.seed;
    if (options.grid == "reduced") check.effort = CheckEffort::reduced();
    for (const BrdfTable* table : tables) check.kernel_models.push_back(*table);
    std::vector<ModelReport> reports;
    for (const BrdfTable* table : tables) {
        note("checking " + table->name);
        reports.push_back(check_model(device, kernels, models, *table, check));
    }
    const double level = judge(reports);
    const bool passed =
        std::all_of(reports.begin(), reports.end(), [](const auto& r) { return r.passed(); });
    std::size_t tests = 0;
    Json json = {{"device", device.info().name},
                 {"driver", device.info().driver},
                 {"seed", options.seed},
                 {"grid", options.grid},
                 {"family_alpha", check_alpha},
                 {"level", level},
                 {"passed", passed},
                 {"models", Json::array()}};
    for (const ModelReport& report : reports) {
        json["models"].push_back(to_json(report));
        for (const Finding& f : report.findings) tests += f.p.size();
        if (options.common.json != "-") print(report, reports.size() == 1);
    }
    json["total_s"] = watch.seconds();
    if (options.common.json != "-")
        std::printf(
            "%zu models, %zu statistical tests at level %.3g each (Sidak, %g together), "
            "%.1f s on %s\n",
            reports.size(), tests, level, check_alpha, watch.seconds(), device.info().name.c_str());
    if (!options.common.json.empty()) write_json(options.common.json, json.dump(2) + "\n");
    return static_cast<int>(passed ? ExitCode::ok : ExitCode::comparison);
}

}  // namespace

Command add_brdf_check(CLI::App& verb) {
    CLI::App* check = verb.add_subcommand("check", "whether models are what they say");
    auto options = std::make_shared<Options>();
    check->add_option("models", options->models, "names of models, files of your own, or all")
        ->required()
        ->type_name("NAME|FILE|all");
    check->add_option("--grid", options->grid, "how much to look at: reduced is for simulators")
        ->check(CLI::IsMember({"full", "reduced"}));
    check->add_option("--seed", options->seed, "of the random numbers");
    check->add_flag("--extremes", options->extremes,
                    "stiff and extreme cases instead: the printed formula against lobe's form");
    add_common_options(*check, options->common);
    return [options] { return run(*options); };
}

}  // namespace lobe
