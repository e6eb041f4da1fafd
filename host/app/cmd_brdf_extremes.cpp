// SPDX-License-Identifier: Apache-2.0
// lobe brdf check --extremes: the printed formula against the model's own functions, in float, at
// stiff parameters, in the lobe's narrowest part and at grazing angles.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/brdf_command.h"
#include "base/error.h"
#include "base/log.h"
#include "base/timer.h"
#include "cl/device.h"
#include "lab/check/extremes.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

// "8.4e-4"; "-" for what could not be measured, 0 for what double itself rounds.
std::string figure(double value) {
    if (std::isnan(value)) return "-";
    if (value < 1e-16) return "0";
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", value);
    std::string s = text;  // the exponent without padding
    const std::size_t digits = s.find('e') + 2;
    if (digits > 1 && s[digits] == '0') s.erase(digits, 1);
    if (s.find("e+") != std::string::npos) s.erase(s.find("e+") + 1, 1);
    return s;
}

std::string percent(std::size_t count, std::size_t of) {
    if (count == 0) return "0";
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", 100.0 * static_cast<double>(count) / of);
    return text;
}

// A float as short as it can be told from its neighbours; one step off one by name.
std::string parameter_value(double value) {
    if (value == 1 - 0x1p-24) return "1-ulp";
    if (value == 1 + 0x1p-23) return "1+ulp";
    char text[32];
    int digits = 4;
    do std::snprintf(text, sizeof text, "%.*g", digits, value);
    while (++digits <= 9 && std::strtof(text, nullptr) != value);
    return text;
}

void print_errors(const FormErrors& e, std::size_t of) {
    std::printf(" |%9s%9s%7s%7s", figure(e.worst).c_str(), figure(e.median).c_str(),
                percent(e.nonfinite, of).c_str(), percent(e.negative, of).c_str());
}

void print(const ExtremesBlock& block, const ExtremesReport& report) {
    const char* heading = " |    worst   median   n.f.   neg.";
    std::printf("\n  %s%s%s%s%s\n", block.parameter.c_str(), block.parameter.empty() ? "" : " ",
                block.directions.c_str(), block.changed.empty() ? "" : ", ", block.changed.c_str());
    std::printf("  %11s", "");
    if (report.has_formula) std::printf(" | %-32s", "printed formula");
    std::printf(" | %-32s |   limit  | same\n  %11s", "ours", "value");
    if (report.has_formula) std::printf("%s", heading);
    std::printf("%s |          | floats\n", heading);
    for (const ExtremesRow& row : block.rows) {
        std::printf("  %11s",
                    block.parameter.empty() ? "defaults" : parameter_value(row.value).c_str());
        if (row.naive) print_errors(*row.naive, report.pairs);
        print_errors(row.ours, report.pairs);
        std::printf(" | %8s | %8s%s\n", figure(row.limit).c_str(), figure(row.arithmetic).c_str(),
                    row.passed() ? "" : "  FAIL");
    }
}

void print(const ExtremesReport& report) {
    std::printf("%-4s  %s, %.1f s\n", report.passed() ? "ok" : "FAIL", report.model.c_str(),
                report.compile_s + report.measure_s);
    for (const ExtremesBlock* block : report.telling()) print(*block, report);
    std::printf("\n");
}

void print_legend(std::size_t pairs, bool has_reference) {
    std::printf(
        "Relative errors of f cos theta_i in float against double, %zu pairs of directions a row.\n"
        "n.f., neg.: percent not finite, negative. limit: the largest change of f as directions\n"
        "move by half an ulp, as rounding to float does: no float arithmetic is better. same "
        "floats:\nworst error of ours against double for the same rounded directions.\n"
        "FAIL: ours is not finite, negative, or worse than %g limits of its pair and %g.\n\n",
        pairs, allowed_conditionings, allowed_rounding);
    if (!has_reference)
        std::printf("The device has no cl_khr_fp64: values are counted, errors are unknown.\n\n");
}

// A number that JSON can hold.
Json number(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? Json() : Json(value > 0 ? "inf" : "-inf");
}

Json to_json(const FormErrors& e) {
    return {{"worst", number(e.worst)},
            {"median", number(e.median)},
            {"nonfinite", e.nonfinite},
            {"negative", e.negative}};
}

Json to_json(const ExtremesReport& report) {
    Json json = {{"model", report.model},         {"passed", report.passed()},
                 {"pairs", report.pairs},         {"compile_s", report.compile_s},
                 {"measure_s", report.measure_s}, {"blocks", Json::array()}};
    for (const ExtremesBlock& block : report.blocks) {
        Json rows = Json::array();
        for (const ExtremesRow& row : block.rows) {
            Json one = {{"value", number(row.value)}, {"passed", row.passed()}};
            if (row.naive) one["formula"] = to_json(*row.naive);
            one["ours"] = to_json(row.ours);
            one["limit"] = number(row.limit);
            one["same_floats_worst"] = number(row.arithmetic);
            one["excess"] = number(row.excess);
            rows.push_back(one);
        }
        json["blocks"].push_back({{"parameter", block.parameter},
                                  {"directions", block.directions},
                                  {"changed", block.changed},
                                  {"rows", rows}});
    }
    return json;
}

}  // namespace

int run_brdf_extremes(const CommonOptions& common, const KernelText& kernels,
                      const std::vector<const BrdfTable*>& models, bool reduced) {
    const Stopwatch watch;
    const Device device = open_device(common.device);
    const std::size_t pairs = reduced ? 50 : 2000;
    const bool text = common.json != "-";
    if (text) print_legend(pairs, device.info().fp64);
    Json json = {{"device", device.info().name},
                 {"driver", device.info().driver},
                 {"passed", true},
                 {"models", Json::array()}};
    bool passed = true;
    for (const BrdfTable* model : models) {
        note("checking the extremes of " + model->name);
        const ExtremesReport report = report_extremes(device, kernels, set_up(*model, {}), pairs);
        passed = passed && report.passed();
        json["models"].push_back(to_json(report));
        if (text) print(report);
    }
    json["passed"] = passed;
    json["total_s"] = watch.seconds();
    if (text)
        std::printf("%zu models, %.1f s on %s\n", models.size(), watch.seconds(),
                    device.info().name.c_str());
    if (!common.json.empty()) write_json(common.json, json.dump(2) + "\n");
    return static_cast<int>(passed ? ExitCode::ok : ExitCode::comparison);
}

}  // namespace lobe
