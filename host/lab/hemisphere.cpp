// SPDX-License-Identifier: Apache-2.0
#include "lab/hemisphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace lobe {
namespace {

constexpr double pi = glm::pi<double>();

// Lobatto's four points on [-1, 1] and their extension to seven by Kronrod's method (W. Gander,
// W. Gautschi, "Adaptive quadrature - revisited", 2000). Both have nodes on the border, so that a
// lobe that ends just inside a patch does not go unseen.
constexpr int points = 7;
constexpr double node[points] = {-1, -0.816496580927726033, -0.447213595499957939,
                                 0,  0.447213595499957939,  0.816496580927726033,
                                 1};
constexpr double kronrod[points] = {11 / 210.0,  72 / 245.0, 125 / 294.0, 16 / 35.0,
                                    125 / 294.0, 72 / 245.0, 11 / 210.0};
constexpr double lobatto[points] = {1 / 6.0, 0, 5 / 6.0, 0, 5 / 6.0, 0, 1 / 6.0};

// Nodes on the horizon are asked for from just above it.
constexpr double lowest_elevation = 1e-9;

using Values = HemisphereJob::Values;

// The two parts of a patch and of its pilot, whose points change places for it.
std::pair<Patch, Patch> cut(const Patch& patch, int axis, double border,
                            std::vector<PilotPoint>& pilot) {
    const auto begin = pilot.begin() + patch.first;
    const auto middle = std::partition(
        begin, begin + patch.count, [&](const PilotPoint& point) { return point[axis] < border; });
    Patch low = patch, high = patch;
    low.high[axis] = high.low[axis] = border;
    low.count = static_cast<std::uint32_t>(middle - begin);
    high.first += low.count;
    high.count -= low.count;
    return {low, high};
}

// What one patch adds, and which way it is best split.
struct Piece {
    Patch patch;
    Values integral, error;
    int axis;
    double highest;  // first value at the nodes
    double zenith;   // and at the normal itself, where a node weighs nothing
};

glm::dvec2 node_at(const Patch& patch, int i, int j) {
    const glm::dvec2 half = 0.5 * (patch.high - patch.low);
    return patch.low + half * (glm::dvec2(node[i], node[j]) + 1.0);
}

// `at` gives the integrand at node i, j times the cosine of the elevation.
template <typename At>
Piece measure(const Patch& patch, const At& at) {
    const glm::dvec2 half = 0.5 * (patch.high - patch.low);
    const double area = half.x * half.y;
    Piece piece{patch, {}, {}, 0, 0, 0};
    Values both{}, along{}, across{}, spread{};
    for (int i = 0; i < points; ++i)
        for (int j = 0; j < points; ++j)
            for (int k = 0; k < HemisphereJob::values; ++k) {
                const double value = at(i, j)[k] * area;
                piece.integral[k] += kronrod[i] * kronrod[j] * value;
                both[k] += lobatto[i] * lobatto[j] * value;
                along[k] += lobatto[i] * kronrod[j] * value;
                across[k] += kronrod[i] * lobatto[j] * value;
            }
    for (int i = 0; i < points; ++i)
        for (int j = 0; j < points; ++j)
            for (int k = 0; k < HemisphereJob::values; ++k)
                spread[k] += kronrod[i] * kronrod[j] *
                             std::abs(at(i, j)[k] * area - 0.25 * piece.integral[k]);
    double first = 0, second = 0;
    for (int k = 0; k < HemisphereJob::values; ++k) {
        const double whole = std::abs(piece.integral[k]) + 1e-300;
        first += std::abs(along[k] - piece.integral[k]) / whole;
        second += std::abs(across[k] - piece.integral[k]) / whole;
        // How QUADPACK (R. Piessens et al., 1983) judges the better rule by the worse.
        const double difference = std::abs(both[k] - piece.integral[k]);
        piece.error[k] =
            spread[k] > 0 ? spread[k] * std::min(1.0, std::pow(200 * difference / spread[k], 1.5))
                          : 0;
    }
    piece.axis = second > first;
    return piece;
}

// A job at work.
struct Progress {
    std::vector<Piece> done;
    std::vector<Patch> open;
};

void request(const HemisphereJob& job, const std::vector<Patch>& open, HemisphereNodes& nodes) {
    for (const Patch& patch : open)
        for (int i = 0; i < points; ++i)
            for (int j = 0; j < points; ++j) {
                const glm::dvec2 at = node_at(patch, i, j);
                nodes.jobs.push_back(job.number);
                nodes.directions.push_back(
                    direction_at(std::max(at.x, lowest_elevation), at.y + job.towards));
            }
}

// Takes the values of the open patches in, from `place` on.
void take(Progress& progress, const std::vector<Values>& values, std::size_t& place) {
    for (const Patch& patch : progress.open) {
        Values weighted[points][points];
        double highest = 0, zenith = 0;
        for (int i = 0; i < points; ++i) {
            const double cosine = std::cos(node_at(patch, i, 0).x);
            for (int j = 0; j < points; ++j, ++place) {
                double& most = cosine > 1e-6 ? highest : zenith;
                most = std::max(most, values[place][0]);
                for (int k = 0; k < HemisphereJob::values; ++k)
                    weighted[i][j][k] = values[place][k] * cosine;
            }
        }
        progress.done.push_back(measure(patch, [&](int i, int j) { return weighted[i][j]; }));
        progress.done.back().highest = highest;
        progress.done.back().zenith = zenith;
    }
    progress.open.clear();
}

// The last value, a second moment, is told but decides nothing.
constexpr int decisive = HemisphereJob::values - 1;

void sum_up(HemisphereJob& job, const std::vector<Piece>& pieces) {
    job.total = job.error = {};
    job.by_cell.assign(job.patches.size(), {});
    for (const Piece& piece : pieces)
        for (int k = 0; k < HemisphereJob::values; ++k) {
            job.total[k] += piece.integral[k];
            job.error[k] += piece.error[k];
            job.by_cell[piece.patch.cell][k] += piece.integral[k];
        }
}

// The axis across which to look for a peak in the patch that the nodes have not met, or -1. Of one
// at the normal the value there tells, else the pilot: then it is the axis on which the points that
// tell of it keep closest to the border.
int hidden_axis(const Piece& piece, const std::vector<PilotPoint>& pilot) {
    if (piece.zenith > 4 * piece.highest) return 0;
    const Patch& patch = piece.patch;
    glm::dvec2 inwards(-1);
    for (std::uint32_t i = patch.first; i < patch.first + patch.count; ++i) {
        if (!(pilot[i].z > 4 * piece.highest)) continue;
        const glm::dvec2 point(pilot[i]);
        const glm::dvec2 near = glm::min(point - patch.low, patch.high - point);
        inwards = glm::max(inwards, near / (patch.high - patch.low));
    }
    return inwards.x < 0 ? -1 : inwards.y < inwards.x;
}

// Splits what hides a peak, and what carries more than its share of an error that is too large.
void split(HemisphereJob& job, Progress& progress, const CubatureOptions& options) {
    if (job.nodes > options.nodes_a_job) return;
    Values share;
    for (int k = 0; k < HemisphereJob::values; ++k) {
        const double budget = options.relative * std::abs(job.total[k]);
        const bool good = k >= decisive || job.error[k] <= budget;
        share[k] = good ? HUGE_VAL : budget / (2 * static_cast<double>(progress.done.size()));
    }
    std::vector<Piece> kept;
    for (const Piece& piece : progress.done) {
        bool coarse = false;
        for (int k = 0; k < HemisphereJob::values; ++k)
            coarse = coarse || piece.error[k] > share[k];
        const int hidden = hidden_axis(piece, job.pilot);
        if (!coarse && hidden < 0) {
            kept.push_back(piece);
            continue;
        }
        const int axis = hidden < 0 ? piece.axis : hidden;
        const double middle = 0.5 * (piece.patch.low[axis] + piece.patch.high[axis]);
        const auto [low, high] = cut(piece.patch, axis, middle, job.pilot);
        progress.open.push_back(low);
        progress.open.push_back(high);
    }
    progress.done = std::move(kept);
}

}  // namespace

glm::dvec3 direction_at(double elevation, double azimuth) {
    const double r = std::cos(elevation);
    return {r * std::cos(azimuth), r * std::sin(azimuth), std::sin(elevation)};
}

glm::dvec2 elevation_azimuth(const glm::dvec3& d, double towards) {
    const double azimuth = std::remainder(std::atan2(d.y, d.x) - towards, 2 * pi);
    return {std::atan2(d.z, std::hypot(d.x, d.y)), azimuth};
}

HemisphereCells::HemisphereCells(std::vector<PilotPoint> pilot, std::size_t cells)
    : pilot_(std::move(pilot)) {
    const auto count = static_cast<std::uint32_t>(pilot_.size());
    build({{0, -pi}, {pi / 2, pi}, 0, 0, count}, std::max<std::size_t>(count / cells, 1));
}

std::uint32_t HemisphereCells::build(const Patch& patch, std::size_t most) {
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({-1, 0, static_cast<std::uint32_t>(patches_.size()), 0});
    const auto begin = pilot_.begin() + patch.first, end = begin + patch.count;
    glm::dvec2 low(1e9), high(-1e9);
    for (auto point = begin; point != end; ++point) {
        low = glm::min(low, glm::dvec2(*point));
        high = glm::max(high, glm::dvec2(*point));
    }
    const int axis = high.y - low.y > high.x - low.x;
    if (patch.count <= most || !(high[axis] - low[axis] > 1e-9)) {
        patches_.push_back(patch);
        patches_.back().cell = nodes_[place].left;
        return place;
    }
    const auto middle = begin + patch.count / 2;
    std::nth_element(begin, middle, end, [axis](const PilotPoint& a, const PilotPoint& b) {
        return a[axis] < b[axis];
    });
    double border = (*middle)[axis];
    if (!(border > low[axis])) border = 0.5 * (low[axis] + high[axis]);
    const auto [left, right] = cut(patch, axis, border, pilot_);
    const std::uint32_t left_place = build(left, most);
    const std::uint32_t right_place = build(right, most);
    nodes_[place] = {axis, border, left_place, right_place};
    return place;
}

std::size_t HemisphereCells::cell_of(const glm::dvec2& point) const {
    std::uint32_t at = 0;
    while (nodes_[at].axis >= 0)
        at = point[nodes_[at].axis] < nodes_[at].border ? nodes_[at].left : nodes_[at].right;
    return nodes_[at].left;
}

void integrate(std::vector<HemisphereJob>& jobs, const HemisphereIntegrand& integrand,
               const CubatureOptions& options) {
    std::vector<Progress> progress(jobs.size());
    for (std::size_t i = 0; i < jobs.size(); ++i) progress[i].open = jobs[i].patches;
    for (int round = 0; round < options.rounds; ++round) {
        HemisphereNodes nodes;
        for (std::size_t i = 0; i < jobs.size(); ++i) request(jobs[i], progress[i].open, nodes);
        if (nodes.jobs.empty()) break;
        const std::vector<Values> values = integrand(nodes);
        std::size_t place = 0;
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            if (progress[i].open.empty()) continue;
            const std::size_t before = place;
            take(progress[i], values, place);
            jobs[i].nodes += place - before;
            sum_up(jobs[i], progress[i].done);
            if (round + 1 < options.rounds) split(jobs[i], progress[i], options);
        }
    }
}

}  // namespace lobe
