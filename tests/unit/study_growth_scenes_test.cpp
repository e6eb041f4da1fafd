// SPDX-License-Identifier: Apache-2.0
// The scenes that grow, and the memory that is watched while they do.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cmath>
#include <cstring>

#include "base/memory_peak.h"
#include "build/pack.h"
#include "study/bench/growth_scenes.h"

using namespace lobe;

TEST(GrowthScenes, HaveAboutTheTrianglesAskedFor) {
    for (const std::size_t wanted : {1000u, 10000u, 300000u}) {
        const double count = double(torus_in_a_room(wanted).triangles.size());
        EXPECT_NEAR(count / double(wanted), 1, 2 / std::sqrt(double(wanted)) + 0.05);
    }
}

TEST(GrowthScenes, LightsShareOnePower) {
    for (const std::size_t lights : {1u, 10u, 1000u}) {
        const PackedScene packed = pack_scene(torus_scene(1000, lights, 16));
        ASSERT_EQ(packed.lights.lights.size(), lights);
        const double scale = packed.placement.scale;
        double power = 0;
        for (const LobeLight& light : packed.lights.lights) {
            EXPECT_LT(light.primitive, packed.triangles.size());
            power += light.area * light.r / (scale * scale);
        }
        EXPECT_NEAR(power, 8, 1e-3);
    }
}

TEST(GrowthScenes, ShapesAreFreedAndTheFilmStays) {
    PackedScene packed = pack_scene(torus_scene(1000, 10, 16));
    free_shapes(packed);
    EXPECT_TRUE(packed.triangles.empty() && packed.vertices.empty() && packed.bvh.nodes.empty());
    EXPECT_TRUE(packed.bvh.triangle_leaves.empty() && packed.lights.lights.empty());
    EXPECT_EQ(packed.frame.window_width, 16u);
    EXPECT_EQ(packed.models.size(), 1u);
}

TEST(MemoryPeak, RisesWithUseAndIsForgotten) {
    if (memory_peak() == 0) GTEST_SKIP() << "the system tells no peak";
    constexpr std::size_t bytes = std::size_t{128} << 20;
    const std::size_t before = memory_peak();
    // Asked of the system itself, for allocators may keep what is given back.
    void* all = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(all, MAP_FAILED);
    std::memset(all, 1, bytes);
    EXPECT_GT(memory_peak(), bytes);
    munmap(all, bytes);
    const std::size_t high = memory_peak();
    EXPECT_GE(high, before);
    forget_memory_peak();
    EXPECT_LT(memory_peak() + bytes / 2, high);
}
