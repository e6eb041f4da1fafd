// SPDX-License-Identifier: Apache-2.0
#include "report/render_report.h"

#include <cmath>
#include <cstdio>

#include "base/progress.h"
#include "base/statistics.h"
#include "report/statistics_report.h"
#include "report/way_on.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

Json optional_number(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

// 95 %.
Json interval(double mean, const std::optional<double>& standard_error, double freedom) {
    if (!standard_error) return nullptr;
    const double half = student_quantile(0.975, freedom) * *standard_error;
    return {mean - half, mean + half};
}

// A whole number where all pixels have the same, else the mean.
Json samples_json(const Estimate& picture) {
    if (picture.mean_samples == picture.samples) return picture.samples;
    return picture.mean_samples;
}

Json error_json(const Estimate& e, const std::optional<TailIndex>& tail) {
    const auto [low, high] = relative_error_interval(e);
    return {{"relative_standard_error", optional_number(e.relative_standard_error)},
            {"relative_standard_error_ci95",
             e.relative_standard_error ? Json({low, high}) : Json(nullptr)},
            {"mean", e.mean},
            {"mean_ci95", interval(e.mean, e.mean_standard_error, e.mean_freedom)},
            {"image_mean", e.image_mean},
            {"image_mean_ci95",
             interval(e.image_mean, e.image_mean_standard_error, e.image_mean_freedom)},
            {"replicates", e.replicates},
            {"tail_index", tail ? Json(tail->alpha) : Json(nullptr)},
            {"masked_pixels", e.masked},
            {"mask", "pixels in which a light is seen directly; left out of all but image_mean"}};
}

Json end_json(const RenderEnd& end) {
    Json json = {{"by", end.by},
                 {"error_target", optional_number(end.error_target)},
                 {"time_target_s", optional_number(end.time_target)}};
    if (end.error_target) {
        json["error_bound95"] = std::isfinite(end.error_bound) ? Json(end.error_bound) : nullptr;
        json["looks"] = end.looks;
    }
    if (end.pilot_samples)
        json["adaptive"] = {{"pilot_spp", end.pilot_samples},
                            {"pilot_s", end.pilot_seconds},
                            {"least_rate", end.least_rate},
                            {"most_rate", end.most_rate}};
    return json;
}

Json features_json(const RenderReport& r) {
    Json in = Json::array(), out = Json::array();
    for (const FeatureState& f : r.features)
        (f.in ? in : out).push_back({{"name", f.name}, {"reason", f.reason}});
    return {{"in", in}, {"out", out}, {"brdfs", r.models}};
}

Json seconds_json(const RenderTimes& t) {
    return {{"parse", t.parse},   {"bvh", t.bvh},     {"compile", t.compile}, {"upload", t.upload},
            {"render", t.render}, {"write", t.write}, {"total", t.total}};
}

double samples_per_second(const RenderReport& r) {
    const double samples = static_cast<double>(r.width) * r.height * r.picture.mean_samples;
    return r.seconds.render > 0 ? samples / r.seconds.render : 0;
}

// " (1.8 to 2.0 %)".
std::string interval_text(const Estimate& picture) {
    if (!picture.relative_standard_error) return "";
    const auto [low, high] = relative_error_interval(picture);
    char text[64];
    std::snprintf(text, sizeof text, " (%.3g to %.3g %%)", 100 * low, 100 * high);
    return text;
}

// Whether a stated error was reached; "" if none was stated.
std::string end_text(const RenderReport& r) {
    if (!r.end.error_target) return "";
    const std::string target = percent_text(*r.end.error_target);
    char line[256];
    if (r.end.by == "error")
        std::snprintf(line, sizeof line,
                      "target   the error is below %s with 95 %% confidence (%u looks)\n",
                      target.c_str(), r.end.looks);
    else
        std::snprintf(line, sizeof line, "target   %s was not reached: ended by %s\n",
                      target.c_str(),
                      r.end.by == "samples" ? "the ceiling of --spp" : r.end.by.c_str());
    return line;
}

std::string way_text(const RenderReport& r) {
    if (!r.picture.relative_standard_error) return "";
    const auto way = way_on(*r.picture.relative_standard_error, r.seconds.render, r.command);
    if (!way) return "";
    return "way on   error " + error_text(r.picture) + "; " + percent_text(way->error) +
           " needs about " + seconds_text(way->more_seconds) + " more: " + way->command + "\n";
}

}  // namespace

Json to_json(const RenderReport& r) {
    return {{"scene", r.scene},
            {"scene_hash", r.scene_hash},
            {"dialect", r.dialect},
            {"lobe", r.version},
            {"device", r.device.name},
            {"platform", r.device.platform},
            {"driver", r.device.driver},
            {"seed", r.seed},
            {"spp", samples_json(r.picture)},
            {"resolution", {r.width, r.height}},
            {"triangles", r.triangles},
            {"spheres", r.spheres},
            {"lights", r.lights},
            {"device_bytes", r.device_bytes},
            {"seconds", seconds_json(r.seconds)},
            {"samples_per_s", samples_per_second(r)},
            {"error", error_json(r.picture, r.tail)},
            {"end", end_json(r.end)},
            {"features", features_json(r)},
            {"integrator", to_text(r.integrator)},
            {"statistics", to_json(r.statistics)},
            {"nonfinite", r.status ? Json(r.status->nonfinite()) : Json(nullptr)},
            {"negative", r.status ? Json(r.status->negative()) : Json(nullptr)},
            {"partial", r.partial},
            {"outputs", r.outputs},
            {"image_hash", r.hash}};
}

std::string to_text(const RenderReport& r) {
    char line[512];
    std::string text;
    for (const std::string& output : r.outputs) text += "picture  " + output + "\n";
    std::snprintf(
        line, sizeof line, "error    %s relative standard error%s at %.4g samples a pixel%s%s\n",
        error_text(r.picture).c_str(), interval_text(r.picture).c_str(), r.picture.mean_samples,
        r.end.pilot_samples ? " in the mean" : "", r.partial ? " (stopped early)" : "");
    text += line;
    if (r.picture.mean_standard_error) {
        std::snprintf(
            line, sizeof line, "mean     %.5g +- %.2g luminance (95 %%)\n", r.picture.mean,
            *r.picture.mean_standard_error * student_quantile(0.975, r.picture.mean_freedom));
        text += line;
    }
    std::snprintf(line, sizeof line,
                  "time     %.2f s: parse %.2f, bvh %.2f, compile %.2f, upload %.2f, render %.2f "
                  "(%s/s), write %.2f\n",
                  r.seconds.total, r.seconds.parse, r.seconds.bvh, r.seconds.compile,
                  r.seconds.upload, r.seconds.render,
                  amount_text(samples_per_second(r), "samples").c_str(), r.seconds.write);
    text += line;
    text += to_text(r.statistics);
    text += "device   " + r.device.name + "\n";
    text += "hash     " + r.hash + "\n";
    return text + end_text(r) + way_text(r);
}

}  // namespace lobe
