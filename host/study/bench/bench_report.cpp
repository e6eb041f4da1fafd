// SPDX-License-Identifier: Apache-2.0
#include "study/bench/bench_report.h"

#include <cmath>
#include <map>

#include "base/error.h"
#include "base/format.h"
#include "report/text_table.h"
#include "study/bench/growth_report.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

std::string millions(double rate, double deviation) {
    return formatted("%.3g +- %.1g", rate / 1e6, deviation / 1e6);
}

std::string scene_text(const BenchScene& s, const BenchPlan& plan) {
    std::string text = formatted(
        "scene      %s, %ux%u, %u samples a pixel; %zu triangles, %zu spheres, %zu lights\n",
        s.name.c_str(), s.width, s.height, s.samples, s.triangles, s.spheres, s.lights);
    text += "samples    " + millions(s.rate, s.rate_deviation) + " M/s, hash " +
            s.image_hash.substr(0, 16) + "\n";
    text += formatted("error      %.3g %%; %g %% takes about %.3g s\n", 100 * s.relative_error,
                      100 * plan.target, s.target_seconds);
    text += formatted(
        "start-up   parse %.3g s, bvh %.3g, upload %.3g; compile cold %.3g, warm %.3g\n",
        s.start_up.parse, s.start_up.bvh, s.start_up.upload, s.compile_cold, s.compile_warm);
    text += formatted("memory     %.1f MB on the device\n", double(s.device_bytes) / 1e6);
    TextTable table({"rays", "count", "met", "M/s", "+-"});
    for (const RayRate& r : s.rays)
        table.add({r.name, std::to_string(r.rays), formatted("%.0f %%", 100 * r.met),
                   formatted("%.3g", r.rate / 1e6), formatted("%.1g", r.rate_deviation / 1e6)});
    return text + table.text();
}

Json rays_json(const BenchScene& scene) {
    Json rays = Json::object();
    for (const RayRate& r : scene.rays)
        rays[r.name] = {{"rays", r.rays},
                        {"met", r.met},
                        {"rays_per_s", r.rate},
                        {"rays_per_s_deviation", r.rate_deviation}};
    return rays;
}

Json scene_json(const BenchScene& s) {
    return {{"name", s.name},
            {"content_hash", s.content_hash},
            {"image_hash", s.image_hash},
            {"resolution", {s.width, s.height}},
            {"spp", s.samples},
            {"triangles", s.triangles},
            {"spheres", s.spheres},
            {"lights", s.lights},
            {"device_bytes", s.device_bytes},
            {"parse_s", s.start_up.parse},
            {"bvh_s", s.start_up.bvh},
            {"upload_s", s.start_up.upload},
            {"compile_cold_s", s.compile_cold},
            {"compile_warm_s", s.compile_warm},
            {"samples_per_s", s.rate},
            {"samples_per_s_deviation", s.rate_deviation},
            {"relative_standard_error", s.relative_error},
            {"target_s", s.target_seconds},
            {"rays", rays_json(s)}};
}

// The figures of a scene that are worth a comparison, by name; the spread is one of the rate's.
struct Figure {
    double value, deviation;
};

std::map<std::string, Figure> figures_of(const Json& scene) {
    std::map<std::string, Figure> all;
    all["samples/s"] = {scene.at("samples_per_s"), scene.at("samples_per_s_deviation")};
    all["seconds to the target"] = {scene.at("target_s"), 0};
    all["compile cold, s"] = {scene.at("compile_cold_s"), 0};
    all["compile warm, s"] = {scene.at("compile_warm_s"), 0};
    all["device bytes"] = {scene.at("device_bytes"), 0};
    for (const auto& [name, r] : scene.at("rays").items())
        all["rays/s, " + name] = {r.at("rays_per_s"), r.at("rays_per_s_deviation")};
    return all;
}

// The same work: kernels may differ, that is what is compared.
const Json* find_like(const Json& report, const Json& wanted) {
    for (const Json& scene : report.at("scenes")) {
        bool alike = true;
        for (const char* key : {"name", "resolution", "spp"})
            alike = alike && scene.at(key) == wanted.at(key);
        if (alike) return &scene;
    }
    return nullptr;
}

void check_kind(const std::string& file, const Json& json) {
    if (!json.is_object() || json.value("kind", "") != "lobe bench")
        throw Error(ExitCode::comparison, "this is no report of lobe bench", file,
                    "write one with: lobe bench --json FILE");
}

std::string spread(double ratio, const Figure& a, const Figure& b) {
    if (a.deviation == 0 || b.deviation == 0) return "";
    return formatted("%.1g", ratio * std::hypot(a.deviation / a.value, b.deviation / b.value));
}

}  // namespace

std::string to_text(const BenchReport& report) {
    std::string text = "device     " + report.device.name + ", " + report.device.platform + ", " +
                       report.device.driver + "\n";
    for (const BenchScene& scene : report.scenes) text += "\n" + scene_text(scene, report.plan);
    if (!report.growth.empty()) text += "\n" + to_text(report.growth);
    return text + formatted("\nhost       %.0f MB at most\n", double(report.host_bytes) / 1e6);
}

Json to_json(const BenchReport& report) {
    Json json = {{"schema", 1},
                 {"kind", "lobe bench"},
                 {"lobe", report.version},
                 {"command", report.command},
                 {"device", report.device.name},
                 {"platform", report.device.platform},
                 {"driver", report.device.driver},
                 {"repeats", report.plan.repeats},
                 {"target", report.plan.target},
                 {"host_bytes", report.host_bytes},
                 {"scenes", Json::array()}};
    for (const BenchScene& scene : report.scenes) json["scenes"].push_back(scene_json(scene));
    if (!report.growth.empty()) json["growth"] = to_json(report.growth);
    return json;
}

std::string comparison_text(const std::string& file_a, const Json& a, const std::string& file_b,
                            const Json& b) {
    check_kind(file_a, a);
    check_kind(file_b, b);
    std::string text = "A  " + file_a + ": lobe " + a.at("lobe").get<std::string>() + ", " +
                       a.at("device").get<std::string>() + ", " +
                       a.at("driver").get<std::string>() + "\nB  " + file_b + ": lobe " +
                       b.at("lobe").get<std::string>() + ", " + b.at("device").get<std::string>() +
                       ", " + b.at("driver").get<std::string>() + "\n";
    bool common = false;
    for (const Json& scene : a.at("scenes")) {
        const Json* other = find_like(b, scene);
        if (!other) continue;
        common = true;
        const bool same = scene.at("image_hash") == other->at("image_hash");
        text += "\n" + scene.at("name").get<std::string>() + ": " +
                (same ? "the same picture to the bit" : "other bits in the picture") + "\n";
        TextTable table({"figure", "A", "B", "B/A", "+-"});
        const auto theirs = figures_of(*other);
        for (const auto& [name, figure] : figures_of(scene)) {
            const auto found = theirs.find(name);
            if (found == theirs.end()) continue;
            const double ratio = found->second.value / figure.value;
            table.add({name, formatted("%.4g", figure.value),
                       formatted("%.4g", found->second.value), formatted("%.3f", ratio),
                       spread(ratio, figure, found->second)});
        }
        text += table.text();
    }
    if (!common)
        throw Error(ExitCode::comparison, "the two reports have no scene in common", file_b,
                    "a scene is the same by name, resolution and samples a pixel");
    return text;
}

}  // namespace lobe
