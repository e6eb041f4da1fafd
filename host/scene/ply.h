// SPDX-License-Identifier: Apache-2.0
// PLY meshes: ascii and binary of both byte orders.
#pragma once

#include <string>

#include "scene/scene.h"

namespace lobe {

// The mesh of a PLY file's bytes, in the file's own space. Polygons become fans of triangles;
// normals (nx, ny, nz; of any length) and texture coordinates (u v, s t, texture_u ...) are taken
// where all vertices have them. Throws Error (scene) with the line and column, or the byte of a
// binary file, of whatever is wrong; nothing is allocated that the file's size does not justify.
Mesh parse_ply(const std::string& path, const std::string& bytes);

}  // namespace lobe
