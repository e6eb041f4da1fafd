// SPDX-License-Identifier: Apache-2.0
// Small scenes made in code.
#pragma once

#include <map>
#include <string>

#include "scene/scene.h"

namespace lobe::test {

// An empty scene of one lambertian material of an albedo (material 0), a square film, a pinhole at
// the origin that looks along +z with x to the right and y up.
Scene small_scene(double albedo, std::uint32_t size = 32, double fov = 60);

// One of lobe's models: its defaults but for some values, grey where they are colours.
Material material(const std::string& model, const std::map<std::string, float>& values = {});

// Adds a shape and gives it for changes.
Shape& add(Scene& scene, Mesh mesh);
Shape& add(Scene& scene, const glm::dvec3& centre, double radius);
Shape& shine(Shape& shape, double radiance, bool two_sided = false);

// The rectangle z = distance of half width `half` that faces the camera of small_scene.
Mesh wall(double distance, double half);

// Moves the camera to `eye`, looking at `target`.
void look(Scene& scene, const glm::dvec3& eye, const glm::dvec3& target);

// A room with boxes and balls, lit by triangles, a sphere and a point, seen through a lens: every
// feature but the environment; `environment` adds that.
Scene busy_scene(std::uint32_t size, bool environment);

}  // namespace lobe::test
