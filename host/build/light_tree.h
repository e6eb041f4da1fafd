// SPDX-License-Identifier: Apache-2.0
// The lights as the kernels choose among them: in a tree of bounds (kernels/light/light_tree.h).
#pragma once

#include <vector>

#include "build/light_bounds.h"
#include "shared/types.h"

namespace lobe {

struct BoundedLight {
    LobeLight light;
    LightBounds bounds;
    bool completes = false;  // the flat quadrilateral that the light before it begins
};

struct LightTree {
    std::vector<LobeLight> lights;     // in the order given, each with its place
    std::vector<LobeLightNode> nodes;  // none for a single light or quadrilateral
    LobeUint root = 0;                 // as LobeLightNode::child
};

// Lights without intensity are in no node: they are never chosen. All without: an empty tree.
// Throws Error (scene) if there are more lights than a node can name.
LightTree make_light_tree(const std::vector<BoundedLight>& lights);

}  // namespace lobe
