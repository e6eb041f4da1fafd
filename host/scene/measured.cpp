// SPDX-License-Identifier: Apache-2.0
#include "scene/measured.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/error.h"

namespace lobe {
namespace {

constexpr double pi = glm::pi<double>();

// The places beside cell (i, j, k): phi_d is periodic, the other axes end.
template <typename Visit>
void visit_neighbours(const std::array<std::uint32_t, 3>& n, std::size_t cell, const Visit& visit) {
    const std::size_t row = n[2], plane = std::size_t{n[1]} * row;
    const std::size_t i = cell / plane, j = cell / row % n[1], k = cell % row;
    if (i > 0) visit(cell - plane);
    if (i + 1 < n[0]) visit(cell + plane);
    if (j > 0) visit(cell - row);
    if (j + 1 < n[1]) visit(cell + row);
    visit(k > 0 ? cell - 1 : cell + row - 1);
    visit(k + 1 < row ? cell + 1 : cell - k);
}

// Cells on either side of a coordinate in [0, 1], and the second one's part.
struct Between {
    std::size_t low, high;
    double part;
};

Between between(double at, std::uint32_t count, bool periodic) {
    const double middle = at * count - 0.5;
    const double below = std::clamp(std::floor(middle), -1.0, count - 1.0);
    Between cells{0, 0, middle - below};
    const auto next = static_cast<std::size_t>(below + 1);
    cells.low = next > 0 ? next - 1 : periodic ? count - 1 : 0;
    cells.high = next < count ? next : periodic ? 0 : count - 1;
    return cells;
}

}  // namespace

DirectionPair directions_at(const MeasuredBrdf& table, std::size_t cell) {
    const auto& n = table.counts;
    const std::size_t i = cell / n[2] / n[1], j = cell / n[2] % n[1], k = cell % n[2];
    const double part = (static_cast<double>(i) + 0.5) / n[0];
    const double theta_h = 0.5 * pi * part * part;
    const double theta_d = 0.5 * pi * (static_cast<double>(j) + 0.5) / n[1];
    const double phi_d = pi * (static_cast<double>(k) + 0.5) / n[2];
    const glm::dvec3 half(std::sin(theta_h), 0, std::cos(theta_h));
    const glm::dvec3 along(std::cos(theta_h), 0, -std::sin(theta_h)), across(0, 1, 0);
    const glm::dvec3 off = std::sin(theta_d) * (std::cos(phi_d) * along + std::sin(phi_d) * across);
    return {std::cos(theta_d) * half - off, std::cos(theta_d) * half + off};
}

void fill_gaps(MeasuredBrdf& table, const std::string& where) {
    std::vector<std::size_t> missing;
    const auto known = [&](std::size_t cell) { return !std::isnan(table.values[cell].x); };
    for (std::size_t cell = 0; cell < table.cells(); ++cell)
        if (!known(cell)) missing.push_back(cell);
    if (missing.size() == table.cells())
        throw Error(ExitCode::scene, "the table has no data at all", where,
                    "negative values say that a cell was not measured");
    while (!missing.empty()) {
        std::vector<std::pair<std::size_t, glm::vec3>> found;
        std::vector<std::size_t> rest;
        for (const std::size_t cell : missing) {
            glm::dvec3 sum(0);
            int count = 0;
            visit_neighbours(table.counts, cell, [&](std::size_t other) {
                if (!known(other)) return;
                sum += glm::dvec3(table.values[other]);
                ++count;
            });
            if (count) {
                found.emplace_back(cell, glm::vec3(sum / static_cast<double>(count)));
            } else {
                rest.push_back(cell);
            }
        }
        for (const auto& [cell, value] : found) table.values[cell] = value;
        missing = std::move(rest);
    }
}

glm::dvec3 interpolate(const MeasuredBrdf& table, const glm::dvec3& wo, const glm::dvec3& wi) {
    const glm::dvec3 s = wo + wi, e = wi - wo;
    const double lean = s.x * s.x + s.y * s.y, length = glm::length(s);
    const double along = s.z * (s.x * e.x + s.y * e.y) - lean * e.z;
    const double across = length * (s.x * e.y - s.y * e.x);
    const double theta_h = std::atan2(std::sqrt(lean), s.z) / (0.5 * pi);
    const double theta_d = std::atan2(glm::length(e), length) / (0.5 * pi);
    const double phi_d = std::atan2(across, along) / pi;
    const auto& n = table.counts;
    const Between h = between(std::sqrt(theta_h), n[0], false);
    const Between d = between(theta_d, n[1], false);
    const Between phi = between(phi_d < 0 ? phi_d + 1 : phi_d, n[2], true);
    glm::dvec3 sum(0);
    for (const auto& [i, wh] : {std::pair(h.low, 1 - h.part), {h.high, h.part}})
        for (const auto& [j, wd] : {std::pair(d.low, 1 - d.part), {d.high, d.part}})
            for (const auto& [k, wp] : {std::pair(phi.low, 1 - phi.part), {phi.high, phi.part}})
                sum += wh * wd * wp * glm::dvec3(table.values[(i * n[1] + j) * n[2] + k]);
    return sum;
}

// Integrated over half vectors, in the variable that spaces the table's cells.
double largest_albedo(const MeasuredBrdf& table) {
    constexpr int azimuths = 64;
    const std::uint32_t rings = 2 * std::clamp<std::uint32_t>(table.counts[0], 64, 128);
    double largest = 0;
    for (int angle = 0; angle < 10; ++angle) {
        const double theta = 0.5 * pi * std::min(angle / 9.0, 0.995);
        const glm::dvec3 wo(std::sin(theta), 0, std::cos(theta));
        glm::dvec3 albedo(0);
        for (std::uint32_t ring = 0; ring < rings; ++ring) {
            const double at = (ring + 0.5) / rings, theta_h = 0.5 * pi * at * at;
            const double area = std::sin(theta_h) * pi * at / rings * 2 * pi / azimuths;
            for (int turn = 0; turn < azimuths; ++turn) {
                const double phi = 2 * pi * (turn + 0.5) / azimuths;
                const glm::dvec3 h(std::sin(theta_h) * std::cos(phi),
                                   std::sin(theta_h) * std::sin(phi), std::cos(theta_h));
                const double cosine = glm::dot(wo, h);
                const glm::dvec3 wi = 2 * cosine * h - wo;
                if (wi.z > 0) albedo += interpolate(table, wo, wi) * (wi.z * 4 * cosine * area);
            }
        }
        largest = std::max({largest, albedo.x, albedo.y, albedo.z});
    }
    return largest;
}

}  // namespace lobe
