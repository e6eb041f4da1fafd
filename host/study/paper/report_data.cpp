// SPDX-License-Identifier: Apache-2.0
// `lobe paper` for programs.
#include <cmath>
#include <cstdio>

#include "report/way_on.h"
#include "study/paper/report.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json interval(double lo, double hi) { return {number(lo), number(hi)}; }

Json ratio(const RatioInterval& r) {
    return {{"ratio", number(r.ratio)}, {"ci95", interval(r.lo, r.hi)}};
}

Json colour(const glm::dvec3& c) { return {c.x, c.y, c.z}; }

Json parameters(const ModelSetting& setting, const std::vector<Wearer>& wearers) {
    Json all = Json::array();
    for (std::size_t w = 0; w < wearers.size(); ++w) {
        const LobeParameters& p = setting.parameters[w];
        all.push_back({{"material", wearers[w].type},
                       {"kd_per_sr", colour(p.kd)},
                       {"ks_per_sr", colour(p.ks)},
                       {"n", p.n}});
    }
    return all;
}

std::string alike(const ModelSetting& setting) {
    if (setting.listing) return "listing";
    return setting.model == "rational" ? "base" : key_of(setting.footing);
}

Json cell(const CellFindings& found, const PaperCell& cell, std::size_t sampler) {
    Json runs = Json::array();
    for (const PaperRun& run : cell.runs)
        runs.push_back({{"seed", run.seed},
                        {"render_s", run.seconds},
                        {"mse", number(run.error.mse)},
                        {"mse_trimmed", number(run.error.mse_trimmed)},
                        {"trimmed_share", number(run.error.trimmed_share)},
                        {"mean_absolute_error", number(run.absolute)}});
    return {{"sampler", paper_samplers[sampler].name},
            {"integrator", to_text(paper_samplers[sampler].integrator)},
            {"start_up_s", cell.start_up.total()},
            {"compile_s", cell.start_up.compile},
            {"render_s", number(found.seconds)},
            {"render_cv", number(found.timing_noise)},
            {"relative_rmse", number(found.rmse)},
            {"relative_rmse_ci95", interval(found.rmse_lo, found.rmse_hi)},
            {"relative_rmse_trimmed", number(found.trimmed)},
            {"worst_pixels_share", number(found.worst_share)},
            {"absolute_error_255", number(found.absolute)},
            {"runs", runs}};
}

Json setting(const PaperReport& report, std::size_t s) {
    const PaperExperiment& e = report.experiment;
    const PaperSetting& setting = e.settings[s];
    Json json = {{"model", setting.setting.model},
                 {"alike_in", alike(setting.setting)},
                 {"parameters", parameters(setting.setting, e.wearers)},
                 {"reference_spp", setting.reference.samples},
                 {"reference_from_cache", setting.reference.from_cache},
                 {"reference_s", setting.reference.seconds},
                 {"reference_mean", number(setting.mean)},
                 {"reference_relative_variance", number(setting.variance)},
                 {"noise_cosine_over_best_at_equal_time", ratio(report.findings.cut[s])},
                 {"cells", Json::array()}};
    for (std::size_t k = 0; k < paper_samplers.size(); ++k)
        json["cells"].push_back(cell(report.findings.cells[s][k], setting.cells[k], k));
    return json;
}

Json against(const AgainstRational& other, const char* model) {
    return {{"model", model},
            {"relative_rmse", ratio(other.rmse)},
            {"relative_rmse_trimmed", ratio(other.trimmed)},
            {"absolute_error", ratio(other.absolute)},
            {"render_time", ratio(other.time)},
            {"p_holm", number(other.judgement.p_holm)},
            {"wilcoxon_p", number(other.judgement.wilcoxon_p)},
            {"verdict", to_text(other.judgement.verdict)},
            {"reason", other.judgement.reason}};
}

Json paper_row() {
    const PaperRow row;
    return {{"render_s", row.seconds},
            {"error", row.error},
            {"error_over_phong", row.to_phong},
            {"error_over_modified_phong", row.to_modified}};
}

}  // namespace

Json to_json(const PaperReport& report) {
    const PaperExperiment& e = report.experiment;
    Json json = {{"schema", 1},
                 {"version", report.version},
                 {"command_line", command_text(report.command)},
                 {"device", report.device.name},
                 {"driver", report.device.driver},
                 {"scene", report.scene},
                 {"scene_hash", report.scene_hash},
                 {"quick", report.quick},
                 {"resolution", {e.width, e.height}},
                 {"spp", report.plan.samples},
                 {"runs_planned", report.plan.runs},
                 {"runs_complete", e.rounds},
                 {"first_seed", report.plan.first_seed},
                 {"stopped", e.stopped},
                 {"masked_pixels", e.masked},
                 {"stray_light_pixels", e.stray},
                 {"seconds",
                  {{"references", e.reference_seconds},
                   {"runs", e.run_seconds},
                   {"total", report.total_seconds}}},
                 {"paper", paper_row()},
                 {"settings", Json::array()},
                 {"ratios", Json::array()},
                 {"claims", Json::array()},
                 {"verdict", verdict_sentence(report)}};
    if (e.rounds > 0)
        for (std::size_t s = 0; s < e.settings.size(); ++s)
            json["settings"].push_back(setting(report, s));
    for (const FootingFindings& f : report.findings.footings)
        json["ratios"].push_back(
            {{"alike_in", key_of(f.footing)},
             {"sampler", paper_samplers[f.sampler].name},
             {"holds", to_text(f.holds())},
             {"rational_over",
              {against(f.against[0], "phong"), against(f.against[1], "modified_phong")}}});
    for (const Claim& claim : report.claims)
        json["claims"].push_back({{"claim", claim.key},
                                  {"statement", claim.statement},
                                  {"verdict", to_text(claim.holds)},
                                  {"condition", claim.condition},
                                  {"figures", claim.figures}});
    return json;
}

std::string to_csv(const PaperReport& report) {
    std::string all =
        "model,alike_in,sampler,seed,spp,render_s,mse,mse_trimmed,trimmed_share,"
        "mean_absolute_error\n";
    for (const PaperSetting& setting : report.experiment.settings)
        for (std::size_t k = 0; k < paper_samplers.size(); ++k)
            for (const PaperRun& run : setting.cells[k].runs) {
                char figures[200];
                std::snprintf(figures, sizeof figures, "%llu,%u,%.6g,%.9g,%.9g,%.6g,%.9g\n",
                              static_cast<unsigned long long>(run.seed), report.plan.samples,
                              run.seconds, run.error.mse, run.error.mse_trimmed,
                              run.error.trimmed_share, run.absolute);
                all += setting.setting.model + "," + alike(setting.setting) + "," +
                       paper_samplers[k].name + "," + figures;
            }
    return all;
}

}  // namespace lobe
