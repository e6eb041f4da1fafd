// SPDX-License-Identifier: Apache-2.0
#include "build/bvh_tree.h"

#include <cstring>
#include <new>

#include "base/error.h"

namespace lobe {
namespace {

constexpr unsigned max_depth = 17;  // 7 waits a level fit the kernels' stack of 128

template <typename Node>
Node* allocate(RTCThreadLocalAllocator allocator) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(Node), 16)) Node();
}

void* create_node(RTCThreadLocalAllocator allocator, unsigned count, void*) {
    auto* node = allocate<TreeBranch>(allocator);
    node->count = count;
    return static_cast<TreeNode*>(node);
}

void set_children(void* pointer, void** children, unsigned count, void*) {
    auto* node = static_cast<TreeBranch*>(static_cast<TreeNode*>(pointer));
    for (unsigned i = 0; i < count; ++i) node->children[i] = static_cast<TreeNode*>(children[i]);
}

Bounds to_bounds(const RTCBounds& b) {
    return {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
}

void set_bounds(void* pointer, const RTCBounds** bounds, unsigned count, void*) {
    auto* node = static_cast<TreeBranch*>(static_cast<TreeNode*>(pointer));
    for (unsigned i = 0; i < count; ++i) {
        RTCBounds aligned;  // Embree's own may be less aligned than their type says
        std::memcpy(&aligned, bounds[i], sizeof aligned);
        node->bounds[i] = to_bounds(aligned);
    }
}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives,
                  size_t count, void*) {
    auto* leaf = allocate<TreeLeaf>(allocator);
    leaf->leaf = true;
    leaf->count = static_cast<unsigned>(count);
    for (size_t i = 0; i < count; ++i) leaf->primitives[i] = primitives[i].primID;
    return static_cast<TreeNode*>(leaf);
}

std::vector<RTCBuildPrimitive> to_build_primitives(const std::vector<Bounds>& bounds) {
    std::vector<RTCBuildPrimitive> primitives;
    primitives.reserve(bounds.size());
    for (unsigned i = 0; i < bounds.size(); ++i) {
        const Bounds& b = bounds[i];
        primitives.push_back({b.lo[0], b.lo[1], b.lo[2], 0, b.hi[0], b.hi[1], b.hi[2], i});
    }
    return primitives;
}

}  // namespace

BvhTree::BvhTree(const std::vector<Bounds>& bounds) {
    if (bounds.empty()) return;
    device_ = rtcNewDevice(nullptr);
    if (!device_) throw Error(ExitCode::internal, "Embree does not start");
    bvh_ = rtcNewBVH(device_);
    std::vector<RTCBuildPrimitive> primitives = to_build_primitives(bounds);
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = 8;
    arguments.maxDepth = max_depth;
    arguments.sahBlockSize = 8;
    arguments.minLeafSize = 8;
    arguments.maxLeafSize = 8;
    arguments.bvh = bvh_;
    arguments.primitives = primitives.data();
    arguments.primitiveCount = primitives.size();
    arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = create_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = create_leaf;
    root_ = static_cast<const TreeNode*>(rtcBuildBVH(&arguments));
    if (!root_)
        throw Error(ExitCode::scene, "no hierarchy can be built over the scene's shapes", "",
                    "many shapes may lie in one place; remove duplicates");
}

BvhTree::~BvhTree() {
    if (bvh_) rtcReleaseBVH(bvh_);
    if (device_) rtcReleaseDevice(device_);
}

}  // namespace lobe
