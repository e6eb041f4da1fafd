// SPDX-License-Identifier: Apache-2.0
#include "lab/page/match_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lobe {
namespace {

std::string padded(const std::string& text, std::size_t width) {
    return std::string(width > text.size() ? width - text.size() : 1, ' ') + text;
}

std::string digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return std::isfinite(value) ? text : "-";
}

nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

// "same half-width" -> "same_half_width"
std::string key_of(const Criterion& criterion) {
    std::string key = std::string("same_") + criterion.name;
    std::replace_if(
        key.begin(), key.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
    return key;
}

}  // namespace

std::string to_text(const std::vector<Match>& matches, const Sharpened& own,
                    const Sharpened& other) {
    const std::string name = other.subject.model.name + " " + other.name();
    const std::size_t width = std::max<std::size_t>(name.size() + 2, 12);
    std::string out = own.name() + " of " + own.subject.model.name + " for the lobe of " + name +
                      ", alike in\n" + padded(name, width);
    for (const Criterion& criterion : criteria) out += "  " + std::string(criterion.name);
    for (const Match& match : matches) {
        out += "\n" + padded(digits(match.value), width);
        for (std::size_t c = 0; c < criteria.size(); ++c)
            out += padded(digits(match.matched[c]), std::string(criteria[c].name).size() + 2);
    }
    return out + "\n";
}

nlohmann::ordered_json to_json(const std::vector<Match>& matches, const Sharpened& own,
                               const Sharpened& other) {
    nlohmann::ordered_json json = {{"model", own.subject.model.name},
                                   {"parameter", own.name()},
                                   {"to_model", other.subject.model.name},
                                   {"to_parameter", other.name()},
                                   {"matches", nlohmann::ordered_json::array()}};
    for (const Match& match : matches) {
        const LobeShape& shape = match.shape;
        nlohmann::ordered_json row = {{"to_value", match.value},
                                      {"to_lobe",
                                       {{"peak_per_sr", number(shape.peak)},
                                        {"least_per_sr", number(shape.base)},
                                        {"peak_curvature_per_rad2", number(shape.curvature)},
                                        {"half_width_rad", number(shape.half_width)},
                                        {"lobe_integral_sr", number(shape.integral)},
                                        {"normal_albedo_of_peak", number(shape.albedo)},
                                        {"median_energy_rad", number(shape.median)}}}};
        for (std::size_t c = 0; c < criteria.size(); ++c)
            row[key_of(criteria[c])] = number(match.matched[c]);
        json["matches"].push_back(row);
    }
    return json;
}

}  // namespace lobe
