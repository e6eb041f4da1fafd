// SPDX-License-Identifier: Apache-2.0
#include "build/light_bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace lobe {
namespace {

constexpr double pi = glm::pi<double>();

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return 2 * std::atan2(glm::length(a - b), glm::length(a + b));
}

// The smallest cone about both cones.
void join_cones(LightBounds& a, const LightBounds& b) {
    const LightBounds& wide = a.spread >= b.spread ? a : b;
    const LightBounds& slim = a.spread >= b.spread ? b : a;
    const double between = angle_between(wide.axis, slim.axis);
    if (between + slim.spread <= wide.spread || wide.spread >= pi) {
        a.axis = glm::dvec3(wide.axis);
        a.spread = std::min(wide.spread, pi);
        return;
    }
    const double spread = 0.5 * (wide.spread + between + slim.spread);
    const glm::dvec3 across = glm::cross(wide.axis, slim.axis);
    if (spread >= pi || glm::length(across) < 1e-9) {
        a.spread = spread >= pi || between > 1 ? pi : spread + 1e-8;
        a.axis = glm::dvec3(wide.axis);
        return;
    }
    const double turn = spread - wide.spread;  // of the wide cone's axis towards the slim one's
    a.axis = glm::normalize(std::sin(between - turn) * wide.axis + std::sin(turn) * slim.axis);
    a.spread = spread;
}

// Solid angle of a cone's directions, those beyond it weighed by how much of their half space's
// light they may have.
double directions(double spread) {
    const double rim = std::min(spread + 0.5 * pi, pi);
    const double s = std::sin(spread), c = std::cos(spread);
    return 2 * pi * (1 - c) +
           0.5 * pi * (2 * rim * s - std::cos(spread - 2 * rim) - 2 * spread * s + c);
}

}  // namespace

LightBounds joined(const LightBounds& a, const LightBounds& b) {
    LightBounds all = a;
    all.low = glm::min(a.low, b.low);
    all.high = glm::max(a.high, b.high);
    all.intensity = a.intensity + b.intensity;
    join_cones(all, b);
    return all;
}

double light_cost(const LightBounds& b) {
    const glm::dvec3 d = b.high - b.low;
    const double area = 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
    return b.intensity * directions(b.spread) * area;
}

}  // namespace lobe
