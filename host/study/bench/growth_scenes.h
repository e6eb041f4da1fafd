// SPDX-License-Identifier: Apache-2.0
// Scenes of any size, made in code, for figures that are to be seen growing.
#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace lobe {

// The box [-1, 1]^3: 12 triangles that face outwards.
Mesh cube();

// A closed torus about z of radii 1 and `tube`, with bumps: 2 * around * across triangles.
Mesh bumpy_torus(unsigned around, unsigned across, double tube = 0.4, double bumps = 0.1);

// That torus in a box of 6 x 6 x 4: about so many triangles, 12 of them the box's.
Mesh torus_in_a_room(std::size_t triangles);

// The same seen from within the box, of one diffuse material, under so many emitting triangles side
// by side below its ceiling, whose light in all is always the same.
Scene torus_scene(std::size_t triangles, std::size_t lights, std::uint32_t width);

}  // namespace lobe
