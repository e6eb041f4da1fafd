// SPDX-License-Identifier: Apache-2.0
// What is known of a light, or of several, from afar: where they are, where they shine, how much.
#pragma once

#include <glm/glm.hpp>

namespace lobe {

struct LightBounds {
    glm::dvec3 low{0}, high{0};  // box; of a light infinitely far away the direction towards it
    bool distant = false;
    double intensity = 0;  // luminance at unit distance in its brightest direction; sums add up
    // Normals of what shines, each into its half space, lie within this angle of a unit axis.
    // From pi on, light may leave everywhere.
    glm::dvec3 axis{0, 0, 1};
    double spread = 0;

    glm::dvec3 centre() const { return 0.5 * (low + high); }
    double radius() const { return 0.5 * glm::length(high - low); }
};

// Bounds of both, which are both distant or both not.
LightBounds joined(const LightBounds& a, const LightBounds& b);

// How much light their parts may seem to bring where they bring none: intensity times solid angle
// of directions times area (Conty and Kulla's measure).
double light_cost(const LightBounds& bounds);

}  // namespace lobe
