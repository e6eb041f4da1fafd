// SPDX-License-Identifier: Apache-2.0
// The eight-wide hierarchy over triangles and spheres. Embree builds the tree; here it is laid out
// as the kernels read it.
#pragma once

#include <vector>

#include "shared/types.h"

namespace lobe {

struct Bvh {
    std::vector<LobeNode> nodes;  // node 0 is the root; there is always one
    std::vector<LobeTriangleLeaf> triangle_leaves;
    std::vector<LobeSphereLeaf> sphere_leaves;
    unsigned depth = 0;  // nodes on the longest way down
};

// Primitives are numbered triangles first. Coordinates lie within [-1, 1]. Throws Error (scene)
// when the tree would outgrow what the kernels' stack can walk.
Bvh build_bvh(const std::vector<LobeTriangle>& triangles, const std::vector<LobeVertex>& vertices,
              const std::vector<LobeSphere>& spheres);

}  // namespace lobe
