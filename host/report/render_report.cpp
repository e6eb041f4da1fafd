// SPDX-License-Identifier: Apache-2.0
#include "report/render_report.h"

#include <cstdio>

#include "base/progress.h"
#include "base/statistics.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

Json optional_number(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

// 95 %; pixels times (K - 1) degrees of freedom are as good as normal.
Json interval(double mean, const std::optional<double>& standard_error) {
    if (!standard_error) return nullptr;
    const double half = normal_quantile(0.975) * *standard_error;
    return {mean - half, mean + half};
}

Json error_json(const Estimate& e) {
    return {{"relative_standard_error", optional_number(e.relative_standard_error)},
            {"mean", e.mean},
            {"mean_ci95", interval(e.mean, e.mean_standard_error)},
            {"image_mean", e.image_mean},
            {"image_mean_ci95", interval(e.image_mean, e.image_mean_standard_error)},
            {"replicates", e.replicates},
            {"masked_pixels", e.masked},
            {"mask", "pixels in which a light is seen directly; left out of all but image_mean"}};
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
            {"spp", r.picture.samples},
            {"resolution", {r.width, r.height}},
            {"triangles", r.triangles},
            {"spheres", r.spheres},
            {"lights", r.lights},
            {"device_bytes", r.device_bytes},
            {"seconds", seconds_json(r.seconds)},
            {"samples_per_s", samples_per_second(r)},
            {"error", error_json(r.picture)},
            {"features", features_json(r)},
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
    std::snprintf(line, sizeof line,
                  "error    %s relative standard error at %llu samples a pixel%s\n",
                  error_text(r.picture).c_str(), static_cast<unsigned long long>(r.picture.samples),
                  r.partial ? " (stopped early)" : "");
    text += line;
    std::snprintf(line, sizeof line,
                  "time     %.2f s: parse %.2f, bvh %.2f, compile %.2f, upload %.2f, render %.2f "
                  "(%s/s), write %.2f\n",
                  r.seconds.total, r.seconds.parse, r.seconds.bvh, r.seconds.compile,
                  r.seconds.upload, r.seconds.render,
                  amount_text(samples_per_second(r), "samples").c_str(), r.seconds.write);
    text += line;
    text += "device   " + r.device.name + "\n";
    text += "hash     " + r.hash + "\n";
    return text;
}

}  // namespace lobe
