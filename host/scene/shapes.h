// SPDX-License-Identifier: Apache-2.0
// Shapes of scene files in world space.
#pragma once

#include <glm/glm.hpp>

#include "scene/context.h"
#include "scene/parameters.h"

namespace lobe {

class Sha256;

// The shape of a Shape directive, without material and light. `files` takes in the bytes of mesh
// files that are read.
Shape read_shape(const Statement& statement, const glm::dmat4& object_to_world,
                 bool reverse_orientation, const ReadContext& context, Sha256& files);

// Meshes from parameters, in their own space.
Mesh read_triangle_mesh(Parameters& parameters);
Mesh read_loop_mesh(Parameters& parameters);

}  // namespace lobe
