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

// Makes one winding of a mesh with normals: triangles that see their normals on the other side than
// most do are turned round. Returns whether the normals then lie against cross(p1 - p0, p2 - p0).
bool unify_winding(Mesh& mesh);

// Triangles without any area.
std::size_t count_degenerate(const Mesh& mesh);

// A shape moved once more, as an instance of it.
Shape moved(const Shape& shape, const glm::dmat4& m, bool& fits);

}  // namespace lobe
