// SPDX-License-Identifier: Apache-2.0
// The layout of the hierarchy; what it finds is tested on the device (kernel/geom_*_test.cpp).
#include <gtest/gtest.h>

#include "build/pack.h"
#include "support/meshes.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

// Every primitive is in exactly one lane of one leaf, and every leaf in exactly one node.
TEST(BuildBvh, HoldsEveryPrimitiveOnce) {
    Random random(2);
    for (const unsigned count : {0u, 1u, 7u, 8u, 9u, 500u, 5000u}) {
        Scene scene = small_scene(0.5);
        if (count) add(scene, triangle_soup(random, count));
        for (unsigned i = 0; i < count / 3; ++i) add(scene, random_point(random), 0.01);
        const PackedScene packed = pack_scene(scene);
        std::vector<int> seen(packed.triangles.size() + packed.spheres.size());
        for (const auto& leaf : packed.bvh.triangle_leaves)
            for (const LobeUint p : leaf.primitive)
                if (p != LOBE_NONE) ++seen.at(p);
        for (const auto& leaf : packed.bvh.sphere_leaves)
            for (const LobeUint p : leaf.primitive)
                if (p != LOBE_NONE) ++seen.at(p);
        for (const int times : seen) ASSERT_EQ(times, 1);
        std::size_t blocks = 0, children = 0;
        for (const LobeNode& node : packed.bvh.nodes)
            for (const LobeUint child : node.child) {
                if (child == LOBE_NONE) continue;
                if (child & LOBE_LEAF) {
                    blocks += ((child >> LOBE_LEAF_SHIFT) & (LOBE_LEAF_BLOCKS - 1)) + 1;
                } else {
                    ++children;
                }
            }
        EXPECT_EQ(blocks, packed.bvh.triangle_leaves.size() + packed.bvh.sphere_leaves.size());
        EXPECT_EQ(children + 1, packed.bvh.nodes.size());
        EXPECT_LE(7 * packed.bvh.depth + 1, 128u) << "the kernels' stack";
    }
}

// Many shapes in one place cannot be split by position; the tree must still end.
TEST(BuildBvh, ManyShapesInOnePlace) {
    Scene scene = small_scene(0.5);
    Mesh mesh = wall(1, 1);
    for (int i = 0; i < 20000; ++i) mesh.triangles.push_back(mesh.triangles[i % 2]);
    add(scene, mesh);
    const PackedScene packed = pack_scene(scene);
    EXPECT_LE(7 * packed.bvh.depth + 1, 128u);
    EXPECT_EQ(packed.triangles.size(), 20002u);
}
