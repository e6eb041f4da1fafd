// SPDX-License-Identifier: Apache-2.0
// The tree as Embree's builder makes it, before it is laid out for the kernels.
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <memory>
#include <vector>

namespace lobe {

struct Bounds {
    std::array<float, 3> lo, hi;
};

struct TreeNode {
    bool leaf = false;
    unsigned count = 0;  // children or primitives
};
struct TreeBranch : TreeNode {
    std::array<Bounds, 8> bounds;
    std::array<TreeNode*, 8> children{};
};
struct TreeLeaf : TreeNode {
    std::array<unsigned, RTC_BUILD_MAX_PRIMITIVES_PER_LEAF> primitives;
};

// Owns the builder and the memory of the tree.
class BvhTree {
  public:
    explicit BvhTree(const std::vector<Bounds>& primitives);
    ~BvhTree();
    BvhTree(const BvhTree&) = delete;
    BvhTree& operator=(const BvhTree&) = delete;

    const TreeNode* root() const { return root_; }  // null where there are no primitives

  private:
    RTCDevice device_ = nullptr;
    RTCBVH bvh_ = nullptr;
    const TreeNode* root_ = nullptr;
};

}  // namespace lobe
