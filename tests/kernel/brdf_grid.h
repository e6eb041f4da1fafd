// SPDX-License-Identifier: Apache-2.0
// Cells and quadrature nodes over the hemisphere, fine where a lobe about the mirror direction is
// sharp. Coordinates: x = 1 - cos of the angle to the mirror direction, and the azimuth about it.
#pragma once

#include <algorithm>
#include <vector>

#include "support/oracle.h"

namespace lobe::test {

struct QuadratureRule {
    std::vector<Long> node, weight;  // on [0, 1]
};

// Gauss and Legendre's rule.
inline QuadratureRule gauss_rule(int count) {
    QuadratureRule rule;
    for (int i = 0; i < count; ++i) {
        Long z = std::cos(pi * (i + 0.75L) / (count + 0.5L)), slope = 1;
        for (int step = 0; step < 50; ++step) {
            Long p = 1, q = 0;
            for (int k = 0; k < count; ++k) {
                const Long r = q;
                q = p;
                p = ((2 * k + 1) * z * q - k * r) / (k + 1);
            }
            slope = count * (z * p - q) / (z * z - 1);
            z -= p / slope;
        }
        rule.node.push_back(0.5L * (1 - z));
        rule.weight.push_back(1 / ((1 - z * z) * slope * slope));
    }
    return rule;
}

class HemisphereGrid {
  public:
    static constexpr int sectors = 8;

    // `edges`: borders of the rings in x beyond 0, in any order. `azimuths`: nodes a sector.
    HemisphereGrid(const vec3l& wo, std::vector<Long> edges, int azimuths = 6)
        : wo_(wo), mirror_(-wo.x, -wo.y, wo.z), azimuth_rule_(gauss_rule(azimuths)) {
        sine_ = std::hypot(wo.x, wo.y);
        const vec3l heading =
            sine_ > 0 ? vec3l(mirror_.x, mirror_.y, 0.0L) / sine_ : vec3l(1, 0, 0);
        up_ = vec3l(-wo.z * heading.x, -wo.z * heading.y, sine_);
        side_ = vec3l(-heading.y, heading.x, 0);
        const Long last = 1 + sine_;  // no higher x above the horizon
        edges.push_back(0);
        edges.push_back(last);
        std::sort(edges.begin(), edges.end());
        for (const Long x : edges)
            if (x >= 0 && x <= last && (edges_.empty() || x > edges_.back() * (1 + 1e-9L)))
                edges_.push_back(x);
        edges_.back() = last;
        for (std::size_t ring = 0; ring + 1 < edges_.size(); ++ring) add_ring(ring);
    }

    int cells() const { return static_cast<int>(edges_.size() - 1) * sectors; }

    int cell_of(const vec3l& wi) const {
        const vec3l d = mirror_ - wi;
        const Long x = 0.5L * glm::dot(d, d);
        const Long turns = std::atan2(glm::dot(wi, side_), glm::dot(wi, up_)) / (2 * pi) + 0.5L;
        const auto above = std::upper_bound(edges_.begin(), edges_.end(), x) - edges_.begin();
        const int ring = std::clamp<int>(static_cast<int>(above) - 1, 0, cells() / sectors - 1);
        return ring * sectors + std::min(static_cast<int>(turns * sectors), sectors - 1);
    }

    std::vector<vec3l> nodes;
    std::vector<Long> weights;  // solid angle
    std::vector<int> node_cells;

  private:
    // Splits where the horizon begins and ends to cut the circles, and where lobes end.
    void add_ring(std::size_t ring) {
        std::vector<Long> breaks = {edges_[ring], edges_[ring + 1]};
        for (const Long x : {1 - sine_, 1.0L})
            if (x > edges_[ring] && x < edges_[ring + 1]) breaks.push_back(x);
        std::sort(breaks.begin(), breaks.end());
        static const QuadratureRule rule = gauss_rule(10);
        for (std::size_t piece = 0; piece + 1 < breaks.size(); ++piece)
            for (std::size_t i = 0; i < rule.node.size(); ++i) {
                // The smooth step removes the square roots that the horizon leaves at the ends.
                const Long v = rule.node[i], width = breaks[piece + 1] - breaks[piece];
                const Long x = breaks[piece] + width * v * v * (3 - 2 * v);
                add_circle(static_cast<int>(ring), x, width * 6 * v * (1 - v) * rule.weight[i]);
            }
    }

    void add_circle(int ring, Long x, Long weight) {
        const Long t = 1 - x, s = std::sqrt(x * (2 - x));
        Long visible = pi;
        if (s * sine_ > 0)
            visible = std::acos(std::clamp(-t * wo_.z / (s * sine_), -1.0L, 1.0L));
        else if (t < 0)
            visible = 0;
        const QuadratureRule& rule = azimuth_rule_;
        for (int sector = 0; sector < sectors; ++sector) {
            const Long low = std::max(2 * pi * sector / sectors - pi, -visible);
            const Long high = std::min(2 * pi * (sector + 1) / sectors - pi, visible);
            if (low >= high) continue;
            for (std::size_t i = 0; i < rule.node.size(); ++i) {
                const Long phi = low + (high - low) * rule.node[i];
                const vec3l wi = t * mirror_ + s * (std::cos(phi) * up_ + std::sin(phi) * side_);
                if (!(wi.z > 1e-37L)) continue;
                nodes.push_back(wi);
                weights.push_back(weight * (high - low) * rule.weight[i]);
                node_cells.push_back(ring * sectors + sector);
            }
        }
    }

    vec3l wo_, mirror_, up_, side_;
    QuadratureRule azimuth_rule_;
    Long sine_;
    std::vector<Long> edges_;
};

// Rings that suit a lobe whose width in x is about `width`: evenly in the logarithm.
inline std::vector<Long> rings_of_width(Long width) {
    std::vector<Long> edges = {0.25L, 0.5L, 0.75L, 0.9L, 1, 1.25L, 1.5L, 1.75L};
    for (Long x = 0.1L * std::min(width, 1.0L); x < 0.2L; x *= 2) edges.push_back(x);
    return edges;
}

}  // namespace lobe::test
