// SPDX-License-Identifier: Apache-2.0
// Where the world goes in render space: moved so that most of the geometry lies around the origin
// and scaled by a power of two so that everything, the eye included, lies within [-1, 1].
// Both happen in double, before any coordinate becomes a float; the scale changes no bit.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace lobe {

struct Placement {
    glm::dvec3 centre{0.0};  // the median of the vertices: outliers do not move it
    double scale = 1;        // a power of two

    glm::dvec3 point(const glm::dvec3& world) const { return (world - centre) * scale; }
    double length(double world) const { return world * scale; }
};

Placement place_scene(const Scene& scene);

}  // namespace lobe
