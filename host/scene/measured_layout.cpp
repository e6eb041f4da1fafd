// SPDX-License-Identifier: Apache-2.0
// A table as the device reads it, and the density by which half vectors are drawn from it.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/measured.h"

namespace lobe {
namespace {

constexpr double pi = glm::pi<double>();
constexpr double least_cosine_share = 0.1;

// What light from everywhere is reflected by one cell of theta_h: the integral of f cos theta_i cos
// theta_o over theta_d and phi_d (4 cos theta_d sin theta_d is the Jacobian), and that of f = 1.
struct Ring {
    double reflected = 0, white = 0;
    double area = 0;  // solid angle of its half vectors

    double value() const { return white > 0 ? reflected / white : 0; }  // mean f
};

// 1 - cos theta_h at a part of the way along the table's axis.
double one_minus_cosine(double at) {
    const double sine = std::sin(0.25 * pi * at * at);
    return 2 * sine * sine;
}

std::vector<Ring> measure_rings(const MeasuredBrdf& table) {
    const auto& n = table.counts;
    std::vector<Ring> rings(n[0]);
    const std::size_t plane = std::size_t{n[1]} * n[2];
    for (std::uint32_t i = 0; i < n[0]; ++i) {
        Ring& ring = rings[i];
        ring.area =
            2 * pi * (one_minus_cosine((i + 1.0) / n[0]) - one_minus_cosine((i + 0.0) / n[0]));
        for (std::size_t cell = i * plane; cell < (i + 1) * plane; ++cell) {
            const DirectionPair pair = directions_at(table, cell);
            const double cosine = 0.5 * glm::length(pair.wo + pair.wi);
            const double weight = std::max(pair.wo.z, 0.0) * std::max(pair.wi.z, 0.0) * 4 * cosine *
                                  std::sqrt(std::max(0.0, 1 - cosine * cosine));
            const glm::dvec3 f(table.values[cell]);
            ring.white += weight;
            ring.reflected += weight * (f.x + f.y + f.z) / 3;
        }
    }
    return rings;
}

// The mean f that a quarter of white light's reflection keeps below: what a diffuse part may be.
double diffuse_level(const std::vector<Ring>& rings) {
    std::vector<std::pair<double, double>> order;  // value, weight
    double total = 0;
    for (const Ring& ring : rings) {
        order.emplace_back(ring.value(), ring.white * ring.area);
        total += order.back().second;
    }
    std::sort(order.begin(), order.end());
    double sum = 0;
    for (const auto& [value, weight] : order) {
        sum += weight;
        if (sum >= 0.25 * total) return value;
    }
    return 0;
}

}  // namespace

std::vector<float> lay_out(const MeasuredBrdf& table) {
    const std::vector<Ring> rings = measure_rings(table);
    const double level = diffuse_level(rings);
    double diffuse = 0, above = 0;
    std::vector<double> x, density;  // nodes: 1 - cos theta_h, and what lies above the diffuse part
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const double rest = std::max(0.0, rings[i].reflected - level * rings[i].white);
        diffuse += level * rings[i].white * rings[i].area;
        above += rest * rings[i].area;
        x.push_back(one_minus_cosine((static_cast<double>(i) + 0.5) / table.counts[0]));
        density.push_back(rest);
    }
    x.insert(x.begin(), 0);
    x.push_back(1);
    density.insert(density.begin(), density.front());
    density.push_back(density.back());
    if (!(above > 0)) std::fill(density.begin(), density.end(), 1.0);
    double mass = 0;
    const auto piece = [&](std::size_t i) {
        return 0.5 * (density[i] + density[i + 1]) * (x[i + 1] - x[i]);
    };
    for (std::size_t i = 0; i + 1 < x.size(); ++i) mass += piece(i);
    const double share =
        above > 0 ? std::clamp(diffuse / (diffuse + above), least_cosine_share, 1.0) : 1;
    std::vector<float> out;
    out.reserve(4 + 3 * x.size() + 3 * table.cells());
    for (const std::uint32_t count : table.counts) out.push_back(static_cast<float>(count));
    out.push_back(static_cast<float>(share));
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        out.push_back(static_cast<float>(x[i]));
        out.push_back(static_cast<float>(density[i] / mass));
        out.push_back(i + 1 < x.size() ? static_cast<float>(std::min(sum / mass, 1.0)) : 1);
        if (i + 1 < x.size()) sum += piece(i);
    }
    for (const glm::vec3& value : table.values) out.insert(out.end(), {value.x, value.y, value.z});
    return out;
}

// A diffuse ground below a lacquer of GGX facets (alpha 0.65) without shadowing, whose gloss grows
// towards grazing angles as R. Schlick's polynomial of 1994 says, and off the plane of incidence so
// that phi_d matters. Few cells: each border is a kink, and a check's cubature must see them all.
MeasuredBrdf made_up_material() {
    MeasuredBrdf table;
    table.counts = {5, 5, 5};
    table.values.resize(std::size_t{5} * 5 * 5);
    for (std::size_t cell = 0; cell < table.cells(); ++cell) {
        const DirectionPair pair = directions_at(table, cell);
        const glm::dvec3 sum = pair.wo + pair.wi;
        const double cosine = 0.5 * glm::length(sum), alpha = 0.65;
        const double height = sum.z / glm::length(sum), squared = height * height;
        const double below = squared * (alpha * alpha - 1) + 1;
        const double facets = alpha * alpha / (pi * below * below);
        const double fresnel = 0.06 + 0.94 * std::pow(1 - cosine, 5);
        const double off_plane = 1 + 2 * (1 - squared) * pair.wi.y * pair.wi.y;
        const double gloss = off_plane * fresnel * facets / (4 * std::max(cosine * cosine, 0.02));
        table.values[cell] = glm::vec3(0.12 + gloss, 0.08 + gloss, 0.04 + gloss);
    }
    return table;
}

std::vector<float> made_up_table() { return lay_out(made_up_material()); }

}  // namespace lobe
