// SPDX-License-Identifier: Apache-2.0
// Loop subdivision of triangle meshes, with boundaries, as pbrt's `loopsubdiv` does it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lobe {

struct SubdivisionMesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;  // unit; empty before subdivision
    std::vector<glm::uvec3> triangles;
};

// Refines a mesh `levels` times and moves its vertices to the limit surface, whose normals it
// gives. Their side is pbrt's: opposite to cross(p1 - p0, p2 - p0). Vertices that no triangle uses
// are dropped. Returns what makes the mesh unfit (see find_edges), or "".
std::string loop_subdivide(SubdivisionMesh& mesh, int levels);

}  // namespace lobe
