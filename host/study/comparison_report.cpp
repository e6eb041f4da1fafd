// SPDX-License-Identifier: Apache-2.0
#include "study/comparison_report.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "report/way_on.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

double median_of(const std::vector<ComparedRun>& runs, double ComparedRun::*member) {
    std::vector<double> values;
    for (const ComparedRun& run : runs) values.push_back(run.*member);
    return median(values);
}

double mean_mse(const std::vector<ComparedRun>& runs) {
    double sum = 0;
    for (const ComparedRun& run : runs) sum += run.error.mse;
    return sum / static_cast<double>(runs.size());
}

Json judgement_json(const Judgement& j) {
    Json json = {{"ratio", j.ratio},
                 {"lo", j.lo},
                 {"hi", j.hi},
                 {"lo_family", j.lo_family},
                 {"hi_family", j.hi_family},
                 {"p", j.p},
                 {"p_holm", j.p_holm},
                 {"wilcoxon_p", j.wilcoxon_p},
                 {"deviation", j.deviation},
                 {"seeds", j.seeds},
                 {"verdict", to_text(j.verdict)}};
    json["reason"] = j.reason.empty() ? Json() : Json(j.reason);
    json["seeds_needed"] = j.seeds_needed ? Json(*j.seeds_needed) : Json();
    json["seeds_for_5_percent"] = j.seeds_for_5_percent ? Json(*j.seeds_for_5_percent) : Json();
    return json;
}

Json row_json(const ComparisonRow& row) {
    Json json = {{"table", row.equal_time ? "equal_time" : "equal_samples"}};
    if (row.equal_time) json["aim_s"] = row.aim_seconds;
    json["samples_a"] = row.samples_a;
    json["samples_b"] = row.samples_b;
    json["render_s_a"] = median_of(row.a, &ComparedRun::seconds);
    json["render_s_b"] = median_of(row.b, &ComparedRun::seconds);
    json["mse_a"] = mean_mse(row.a);
    json["mse_b"] = mean_mse(row.b);
    if (row.equal_time) json["timing_noise"] = row.ratios.timing_noise;
    json.update(judgement_json(row.judgement));
    json["trimmed"] = judgement_json(row.trimmed);
    return json;
}

Json arm_json(const ComparedArm& arm) {
    return {{"name", arm.name},
            {"scene", arm.scene},
            {"options", arm.options},
            {"integrator", arm.integrator},
            {"content_hash", arm.content_hash},
            {"start_up_s", arm.start_up.total()},
            {"compile_s", arm.start_up.compile},
            {"compiled_from_cache", arm.start_up.compiled_from_cache},
            {"nonfinite", arm.nonfinite},
            {"reference",
             {{"samples", arm.reference_samples},
              {"render_s", arm.reference_seconds},
              {"from_cache", arm.reference_from_cache},
              {"variance", arm.reference_variance},
              {"mean", arm.mean}}}};
}

Json scene_json(const SceneComparison& scene) {
    Json json = {
        {"a", arm_json(scene.a)}, {"b", arm_json(scene.b)}, {"same_content", scene.same_content},
        {"width", scene.width},   {"height", scene.height}, {"masked_pixels", scene.masked},
        {"rows", Json::array()}};
    for (const ComparisonRow& row : scene.rows) json["rows"].push_back(row_json(row));
    return json;
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string cell = "\"";
    for (char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
    return cell + "\"";
}

void add_csv_runs(std::string& csv, const ComparedArm& arm, const char* name,
                  const ComparisonRow& row, const std::vector<ComparedRun>& runs) {
    for (const ComparedRun& run : runs) {
        char numbers[200];
        std::snprintf(numbers, sizeof numbers, ",%s,%s,%llu,%u,%.9g,%.9g,%.9g,%.9g\n",
                      row.equal_time ? "equal_time" : "equal_samples", name,
                      static_cast<unsigned long long>(run.seed), run.samples, run.seconds,
                      run.error.mse, run.error.mse_trimmed, run.error.trimmed_share);
        csv += csv_cell(arm.scene) + numbers;
    }
}

}  // namespace

void judge_report(ComparisonReport& report) {
    judge_rows(report.scenes);
    report.combined.clear();
    report.combined_trimmed.clear();
    if (report.scenes.size() < 2) return;
    for (std::size_t r = 0; r < report.scenes.front().rows.size(); ++r) {
        std::vector<PairedRatios> ratios, trimmed;
        for (const SceneComparison& scene : report.scenes) {
            ratios.push_back(scene.rows[r].ratios);
            trimmed.push_back(scene.rows[r].trimmed_ratios);
        }
        report.combined.push_back(judge({combined(ratios)}).front());
        report.combined_trimmed.push_back(judge({combined(trimmed)}).front());
    }
}

std::size_t headline_row(const ComparisonReport& report) {
    const std::vector<ComparisonRow>& rows = report.scenes.front().rows;
    std::size_t chosen = 0;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        if (rows[r].equal_time != report.by_time) continue;
        const bool better = rows[chosen].equal_time != report.by_time ||
                            rows[r].samples_a >= rows[chosen].samples_a;
        if (better) chosen = r;
    }
    return chosen;
}

const Judgement& headline(const ComparisonReport& report) {
    const std::size_t row = headline_row(report);
    return report.combined.empty() ? report.scenes.front().rows[row].judgement
                                   : report.combined[row];
}

Json to_json(const ComparisonReport& report) {
    const ComparisonPlan& plan = report.plan;
    Json json = {{"schema", 1},
                 {"version", report.version},
                 {"command", command_text(report.command)},
                 {"device", report.device.name},
                 {"driver", report.device.driver},
                 {"seeds", plan.seeds},
                 {"first_seed", plan.first_seed},
                 {"own_seeds", plan.own_seeds},
                 {"win_above", win_above},
                 {"loss_below", loss_below},
                 {"scenes", Json::array()}};
    for (const SceneComparison& scene : report.scenes) json["scenes"].push_back(scene_json(scene));
    if (!report.combined.empty()) json["combined"] = Json::array();
    for (std::size_t r = 0; r < report.combined.size(); ++r) {
        const ComparisonRow& row = report.scenes.front().rows[r];
        Json entry = {{"table", row.equal_time ? "equal_time" : "equal_samples"}};
        entry.update(judgement_json(report.combined[r]));
        entry["trimmed"] = judgement_json(report.combined_trimmed[r]);
        json["combined"].push_back(entry);
    }
    json["headline"] = {{"table", report.by_time ? "equal_time" : "equal_samples"},
                        {"row", headline_row(report)}};
    json["headline"].update(judgement_json(headline(report)));
    json["headline"]["sentence"] = verdict_sentence(report);
    return json;
}

std::string to_csv(const ComparisonReport& report) {
    std::string csv = "scene,table,arm,seed,samples,render_s,mse,mse_trimmed,trimmed_share\n";
    for (const SceneComparison& scene : report.scenes)
        for (const ComparisonRow& row : scene.rows) {
            add_csv_runs(csv, scene.a, "A", row, row.a);
            add_csv_runs(csv, scene.b, "B", row, row.b);
        }
    return csv;
}

}  // namespace lobe
