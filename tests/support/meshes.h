// SPDX-License-Identifier: Apache-2.0
// Meshes made in code, and the rays and hits of the geometry tests.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "base/random.h"
#include "study/bench/growth_scenes.h"

namespace lobe::test {

using lobe::bumpy_torus;
using lobe::cube;

// The unit sphere from an icosahedron, each triangle cut in four `levels` times: 20 * 4^levels.
Mesh icosphere(int levels);

// The rectangle of corners c, c + a, c + a + b, c + b; its normal is a x b.
Mesh rectangle(const glm::dvec3& c, const glm::dvec3& a, const glm::dvec3& b);

// `count` triangles anywhere in [-1, 1]^3: most small, some huge, some slivers, some without area,
// some in the planes of the axes, some given twice or nearly so.
Mesh triangle_soup(Random& random, unsigned count);

void transform(Mesh& mesh, const glm::dmat4& matrix);

glm::dvec3 random_direction(Random& random);
glm::dvec3 random_point(Random& random);  // in [-1, 1]^3

}  // namespace lobe::test
