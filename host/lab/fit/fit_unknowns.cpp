// SPDX-License-Identifier: Apache-2.0
#include "lab/fit/fit_unknowns.h"

#include <algorithm>
#include <cmath>

namespace lobe {
namespace {

// A logarithm needs a least value where a row has 0: no lobe is told from one this much wider.
constexpr double least_of_unbounded = 1e-2, most_of_unbounded = 1e10;

Unknown colour(std::size_t row, int channel, const BrdfParameter& p, const Brightness& data) {
    const double typical = std::max(data.typical[channel], 1e-6);
    const double largest = std::max(data.largest[channel], 2 * typical);
    Unknown u{row, channel, false, typical, 0, 0, 0.1 * typical, largest};
    if (std::isfinite(p.highest)) {
        u.scale = std::max(p.highest - p.lowest, 1e-30);
        u.least_start = std::max(p.lowest, 1e-2 * std::min(p.highest, 1.0));
        u.greatest_start = std::min(p.highest, 10.0);
    }
    u.lowest = p.lowest / u.scale;
    u.highest = p.highest / u.scale;
    return u;
}

Unknown number(std::size_t row, const BrdfParameter& p) {
    Unknown u{row, 0, false, 1, p.lowest, p.highest, p.lowest, p.highest};
    if (std::isinf(p.highest) && p.lowest >= 0) {
        u.logarithmic = true;
        u.lowest = std::log(std::max(p.lowest, least_of_unbounded));
        u.highest = std::log(most_of_unbounded);
        u.least_start = std::max(p.lowest, 1.0);
        u.greatest_start = 1e5 * u.least_start;
        return u;
    }
    if (std::isinf(p.lowest)) u.least_start = p.standard - 5;
    if (std::isinf(p.highest)) u.greatest_start = std::max(p.standard, u.least_start) + 5;
    if (std::isfinite(p.highest - p.lowest)) u.scale = std::max(p.highest - p.lowest, 1e-30);
    // Roughness and the like: from a thousandth of the range, and up to one.
    if (p.lowest >= 0 && std::isfinite(p.highest)) {
        u.least_start = std::max(p.lowest, 1e-3 * p.highest);
        if (p.lowest == 0) u.greatest_start = std::min(p.highest, 1.0);
    }
    u.lowest = p.lowest / u.scale;
    u.highest = p.highest / u.scale;
    return u;
}

}  // namespace

double Unknown::parameter(double x) const { return logarithmic ? std::exp(x) : scale * x; }

double Unknown::x_of(double parameter) const {
    return std::clamp(logarithmic ? std::log(parameter) : parameter / scale, lowest, highest);
}

std::vector<Unknown> unknowns_of(const Subject& subject, const std::vector<std::string>& held,
                                 const Brightness& data) {
    std::vector<Unknown> unknowns;
    for (std::size_t row = 0; row < subject.model.parameters.size(); ++row) {
        const BrdfParameter& p = subject.model.parameters[row];
        if (std::find(held.begin(), held.end(), p.name) != held.end()) continue;
        if (p.kind == BrdfParameterKind::number) unknowns.push_back(number(row, p));
        for (int k = 0; p.kind == BrdfParameterKind::color && k < 3; ++k)
            unknowns.push_back(colour(row, k, p, data));
    }
    return unknowns;
}

BrdfRows rows_at(const Subject& subject, const std::vector<Unknown>& unknowns, const double* x) {
    BrdfRows rows = subject.rows;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const Unknown& u = unknowns[i];
        const BrdfParameter& p = subject.model.parameters[u.row];
        const double value = std::clamp(u.parameter(x[i]), p.lowest, p.highest);
        rows[u.row][static_cast<std::size_t>(u.channel)] = static_cast<float>(value);
    }
    return rows;
}

std::vector<std::vector<double>> starting_points(const std::vector<Unknown>& unknowns, int count,
                                                 std::uint64_t seed) {
    std::vector<std::vector<double>> starts(static_cast<std::size_t>(count));
    Random random(seed);
    std::vector<double> parts(starts.size());
    for (const Unknown& u : unknowns) {
        if (u.channel == 0) {
            for (std::size_t k = 0; k < parts.size(); ++k)
                parts[k] = (static_cast<double>(k) + 0.5) / static_cast<double>(parts.size());
            for (std::size_t k = parts.size(); k > 1; --k)
                std::swap(parts[k - 1], parts[random.below(static_cast<std::uint32_t>(k))]);
        }
        for (std::size_t k = 0; k < starts.size(); ++k) {
            const double value =
                u.least_start > 0
                    ? u.least_start * std::pow(u.greatest_start / u.least_start, parts[k])
                    : u.least_start + parts[k] * (u.greatest_start - u.least_start);
            starts[k].push_back(u.x_of(value));
        }
    }
    return starts;
}

}  // namespace lobe
