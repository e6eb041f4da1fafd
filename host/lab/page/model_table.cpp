// SPDX-License-Identifier: Apache-2.0
#include "lab/page/model_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/luminance.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

// Right-aligned columns of one width.
constexpr int column = 11;

std::string cell(const std::string& text) {
    const std::size_t width = static_cast<std::size_t>(column);
    return (text.size() < width ? std::string(width - text.size(), ' ') : " ") + text;
}

std::string cell(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return std::isfinite(value) ? cell(std::string(text)) : cell(std::string("-"));
}

double degrees(const std::optional<double>& radians) {
    return radians ? glm::degrees(*radians) : std::nan("");
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json channels(const glm::dvec3& v) { return {number(v.x), number(v.y), number(v.z)}; }

Json parameters(const Subject& subject) {
    Json json;
    for (std::size_t i = 0; i < subject.rows.size(); ++i) {
        const BrdfParameter& p = subject.model.parameters[i];
        const auto& row = subject.rows[i];
        if (p.kind == BrdfParameterKind::color)
            json[p.name] = channels({row[0], row[1], row[2]});
        else if (p.kind == BrdfParameterKind::choice || p.kind == BrdfParameterKind::table)
            json[p.name] = value_text(p, row);
        else
            json[p.name] = number(row[0]);
    }
    return json;
}

}  // namespace

ModelTable measure_model(BrdfProbe& probe, const Subject& subject,
                         const std::vector<double>& angles, double azimuth) {
    probe.set_parameters({subject.rows}, subject.tables);
    ModelTable table{subject, probe.claims()[0], {}, {}};
    for (const double angle : angles) {
        table.light.push_back(angle);
        if (angle > 0) table.light.push_back(-angle);
    }
    std::sort(table.light.begin(), table.light.end());
    const Plane plane(probe, azimuth);
    std::vector<PlaneView> views;
    std::vector<AlbedoCase> cases;
    std::vector<PlanePoint> points;
    for (const double angle : angles) {
        views.push_back({0, glm::radians(angle)});
        cases.push_back({0, plane.viewer(std::min(glm::radians(angle), grazing))});
        for (const double light : table.light)
            points.push_back({views.back(), glm::radians(light)});
    }
    const std::vector<Albedo> albedos = directional_albedos(probe, cases);
    const std::vector<PlaneLobe> lobes = plane.lobes(views);
    const std::vector<glm::dvec3> values = plane.values(points);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * table.light.size());
        table.views.push_back({angles[i],
                               albedos[i],
                               lobes[i],
                               {first, first + static_cast<std::ptrdiff_t>(table.light.size())}});
    }
    return table;
}

std::string to_text(const ModelTable& table) {
    std::string out = table.subject.model.title() + "\n" + table.subject.model.name + " with " +
                      table.subject.text() + "\n\n";
    for (const char* title : {"view", "albedo", "peak", "at", "half-width", "least"})
        out += cell(std::string(title));
    out += "\n";
    for (const char* unit : {"deg", "", "1/sr", "deg", "deg", "1/sr"})
        out += cell(std::string(unit));
    for (const ViewRow& row : table.views) {
        const PlaneLobe& lobe = row.lobe;
        out += "\n" + cell(row.degrees) + cell(luminance(row.albedo.value)) + cell(lobe.peak) +
               cell(lobe.any ? glm::degrees(lobe.at) : std::nan("")) +
               cell(degrees(lobe.half_width())) + cell(lobe.base);
    }
    out += "\n\nf in 1/sr for light from the left column's angle, by angle of view\n" +
           cell(std::string("deg"));
    for (const ViewRow& row : table.views) out += cell(row.degrees);
    for (std::size_t i = 0; i < table.light.size(); ++i) {
        out += "\n" + cell(table.light[i]);
        for (const ViewRow& row : table.views) out += cell(luminance(row.f[i]));
    }
    return out + "\n";
}

nlohmann::ordered_json to_json(const ModelTable& table) {
    Json json = {{"model", table.subject.model.name},
                 {"title", table.subject.model.title()},
                 {"parameters", parameters(table.subject)},
                 {"claims",
                  {{"reciprocal", table.claims.reciprocal},
                   {"conserves_energy", table.claims.conserves_energy},
                   {"keeps_samples", table.claims.keeps_samples}}},
                 {"light_deg", table.light},
                 {"views", Json::array()}};
    for (const ViewRow& row : table.views) {
        const PlaneLobe& lobe = row.lobe;
        Json view = {{"view_deg", row.degrees},
                     {"albedo", channels(row.albedo.value)},
                     {"albedo_of_mirror_part", channels(row.albedo.mirror)},
                     {"albedo_error", number(row.albedo.error)},
                     {"peak_per_sr", number(lobe.peak)},
                     {"peak_light_deg", lobe.any ? Json(glm::degrees(lobe.at)) : Json(nullptr)},
                     {"least_per_sr", number(lobe.base)},
                     {"half_width_deg", number(degrees(lobe.half_width()))},
                     {"half_width_below_deg", number(degrees(lobe.below))},
                     {"half_width_above_deg", number(degrees(lobe.above))},
                     {"f_per_sr", Json::array()}};
        for (const glm::dvec3& f : row.f) view["f_per_sr"].push_back(channels(f));
        json["views"].push_back(view);
    }
    return json;
}

}  // namespace lobe
