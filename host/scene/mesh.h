// SPDX-License-Identifier: Apache-2.0
// Moving meshes and telling their sides.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace lobe {

// Transforms positions and normals; normals become unit. Returns false if a position is no longer
// finite.
bool transform_mesh(Mesh& mesh, const glm::dmat4& m);

// Gives vertices whose normal is zero the mean normal of their triangles. Returns how many.
std::size_t mend_normals(Mesh& mesh);

// Triangles whose vertex normals lie on the side away from cross(p1 - p0, p2 - p0), and all
// triangles that have a side.
struct Sides {
    std::size_t against = 0, all = 0;
};
Sides count_sides(const Mesh& mesh);

// Triangles without any area.
std::size_t count_degenerate(const Mesh& mesh);

// A shape moved once more, as an instance of it.
Shape moved(const Shape& shape, const glm::dmat4& m, bool& fits);

}  // namespace lobe
