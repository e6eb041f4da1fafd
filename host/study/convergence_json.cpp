// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "study/convergence_report.h"
#include "report/way_on.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

Json measured(const Studentised& figure) {
    return {{"value", figure.value}, {"standard_error", figure.error}};
}

Json band(const Interval& interval) { return {interval.low, interval.high}; }

Json run_json(const ConvergenceRun& run, const StartUp& start) {
    return {{"seed", run.seed},
            {"spp", run.samples},
            {"wall_s", run.seconds},
            {"compile_s", start.compile},
            {"bvh_s", start.bvh},
            {"upload_s", start.upload},
            {"mse0", run.mse0},
            {"mse_ref", run.mse},
            {"mse_ref_rgb", run.rgb},
            {"mse_trim", run.mse_trimmed},
            {"bias2", run.bias_squared},
            {"relmse", run.relmse},
            {"relmse_trim", run.relmse_trimmed},
            {"smape", run.smape},
            {"p99", run.p99},
            {"max", run.max},
            {"nonfinite", run.nonfinite},
            {"negative", run.negative},
            {"hash", run.hash}};
}

Json level_json(const ConvergenceReport& r, const ConvergenceLevel& l) {
    Json mse = measured(l.mse);
    mse["ci95"] = band(l.mse_band);
    return {{"spp", l.samples},
            {"wall_s", l.seconds},
            {"wall_deviation_s", l.seconds_deviation},
            {"relative_error", relative_error(r, l.mse.value)},
            {"mse", mse},
            {"mse_trim", l.mse_trimmed},
            {"mse0", measured(l.mse0)},
            {"bias2", measured(l.bias_squared)},
            {"mean_difference", measured(l.mean_difference)},
            {"relmse", measured(l.relmse)},
            {"relmse_trim", l.relmse_trimmed},
            {"smape", l.smape},
            {"efficiency_per_s", l.efficiency}};
}

Json fit_json(const ConvergenceReport& r) {
    const ConvergenceFit& f = r.fit;
    return {{"v", f.floor.slope},
            {"v_se", f.floor.slope_error},
            {"v_ci95", band(f.v_band)},
            {"b2", f.floor.intercept},
            {"b2_se", f.b2_error},
            {"b2_ci95", band(f.b2_band)},
            {"b2_p", f.b2_p},
            {"covariance", f.floor.covariance},
            {"chi_square", f.floor.chi_square},
            {"fit_p", f.floor.p()},
            {"slope", f.power.slope},
            {"slope_se", f.power.slope_error},
            {"slope_ci95", band(f.slope_band)},
            {"c_s_per_sample", f.seconds_per_sample},
            {"overhead_s", f.overhead},
            {"ttuv_s", f.unit_variance_seconds},
            {"ttuv_s_ci95", band(f.unit_variance_band)},
            {"target_relative_error", r.plan.target},
            {"target_spp", f.target_samples},
            {"target_render_s", f.target_seconds},
            {"target_total_s", r.start_up.total() + f.target_seconds}};
}

Json features_json(const ConvergenceReport& r, bool in) {
    Json names = Json::array();
    for (const FeatureState& feature : r.features)
        if (feature.in == in) names.push_back(feature.name);
    return names;
}

Json reference_json(const ConvergenceReport& r) {
    return {{"spp", r.reference.samples},       {"seed", r.reference.seed},
            {"file", r.reference.file},         {"from_cache", r.reference.from_cache},
            {"render_s", r.reference.seconds},  {"mean", r.reference_mean},
            {"variance", r.reference_variance}, {"relmse_epsilon", r.relmse_epsilon}};
}

Json start_json(const ConvergenceReport& r) {
    return {{"parse_s", r.start_up.parse},
            {"bvh_s", r.start_up.bvh},
            {"compile_s", r.start_up.compile},
            {"compile_again_s", r.compile_again},
            {"compile_cold_s", r.compile_cold ? Json(*r.compile_cold) : Json(nullptr)},
            {"upload_s", r.start_up.upload},
            {"total_s", r.start_up.total()}};
}

Json bias_json(const ConvergenceReport& r) {
    const BiasVerdict bias = judge_bias(r);
    return {{"found", bias.found},
            {"mean_z", bias.mean_z},
            {"bias2_z", bias.squared_z},
            {"b2_z", bias.floor_z},
            {"b2_counts", bias.floor_counts}};
}

Json scene_json(const ConvergenceReport& r) {
    Json json = {
        {"scene",
         {{"path", r.path},
          {"content_sha256", r.content_hash},
          {"resolution", {r.width, r.height}},
          {"triangles", r.triangles},
          {"spheres", r.spheres},
          {"lights", r.lights},
          {"brdfs", r.models},
          {"features_compiled", features_json(r, true)},
          {"features_left_out", features_json(r, false)}}},
        {"sampler", to_text(r.integrator)},
        {"seed0", r.plan.first_seed},
        {"seeds", r.seeds},
        {"masked_pixels", r.masked},
        {"mask",
         r.plan.mask ? "pixels in which a light is seen directly, and their neighbours" : "none"},
        {"start_up", start_json(r)},
        {"reference", reference_json(r)},
        {"runs", Json::array()},
        {"levels", Json::array()}};
    for (const ConvergenceRun& run : r.runs) json["runs"].push_back(run_json(run, r.start_up));
    for (const ConvergenceLevel& level : r.levels) json["levels"].push_back(level_json(r, level));
    json["fit"] = r.levels.empty() ? Json(nullptr) : fit_json(r);
    json["ci"] = {
        {"method", "percentile-t bootstrap over seeds"}, {"level", 0.95}, {"B", r.plan.resamples}};
    json["tail_index"] =
        r.tail ? Json{{"alpha", r.tail->alpha}, {"standard_error", r.tail->error}} : Json(nullptr);
    json["bias"] = r.levels.empty() ? Json(nullptr) : bias_json(r);
    json["partial"] = r.stopped;
    json["warnings"] = r.warnings;
    return json;
}

std::string cpu_name() {
    std::FILE* file = std::fopen("/proc/cpuinfo", "r");
    char line[512];
    std::string name;
    while (file && name.empty() && std::fgets(line, sizeof line, file)) {
        const std::string text = line;
        const std::size_t colon = text.find(": ");
        if (text.compare(0, 10, "model name") == 0 && colon != std::string::npos)
            name = text.substr(colon + 2, text.size() - colon - 3);
    }
    if (file) std::fclose(file);
    return name;
}

Json environment(const ConvergenceResults& results, const DeviceInfo& device) {
    double load = 0;
    if (getloadavg(&load, 1) != 1) load = 0;
    return {{"schema", 1},
            {"lobe", {{"version", results.version}, {"fp_contract", "off"}}},
            {"command", command_text(results.command)},
            {"device",
             {{"platform", device.platform},
              {"name", device.name},
              {"driver", device.driver},
              {"compute_units", device.compute_units},
              {"global_memory_bytes", device.global_memory}}},
            {"host", {{"cpu", cpu_name()}, {"load1", load}}}};
}

}  // namespace

Json to_json(const ConvergenceResults& results) {
    Json json =
        environment(results, results.scenes.empty() ? DeviceInfo() : results.scenes.front().device);
    json["scenes"] = Json::array();
    for (const ConvergenceReport& report : results.scenes)
        json["scenes"].push_back(scene_json(report));
    return json;
}

std::string to_csv(const ConvergenceResults& results) {
    std::string csv =
        "scene,seed,spp,wall_s,compile_s,bvh_s,upload_s,mse0,mse_ref,bias2,relmse,relmse_trim,"
        "smape,max,nonfinite,negative,hash\n";
    char line[512];
    for (const ConvergenceReport& r : results.scenes)
        for (const ConvergenceRun& run : r.runs) {
            std::snprintf(line, sizeof line,
                          ",%llu,%u,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%u,%u,",
                          static_cast<unsigned long long>(run.seed), run.samples, run.seconds,
                          r.start_up.compile, r.start_up.bvh, r.start_up.upload, run.mse0, run.mse,
                          run.bias_squared, run.relmse, run.relmse_trimmed, run.smape, run.max,
                          run.nonfinite, run.negative);
            csv += "\"" + r.path + "\"" + line + run.hash + "\n";
        }
    return csv;
}

}  // namespace lobe
