// SPDX-License-Identifier: Apache-2.0
// Render space: the middle of the geometry at the origin, all within [-1, 1], a scale that changes
// no bit.
#include <gtest/gtest.h>

#include <cmath>

#include "build/pack.h"
#include "support/meshes.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

TEST(BuildPlacement, EverythingLiesWithinTheUnitCube) {
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        Scene scene = small_scene(0.5);
        const double size = random.log_uniform(1e-9, 1e9);
        const glm::dvec3 offset = random.log_uniform(1e-3, 1e3) * size * random_point(random);
        Mesh mesh = triangle_soup(random, 20);
        for (glm::dvec3& p : mesh.positions) p = size * p + offset;
        add(scene, mesh);
        add(scene, offset + size * random_point(random), size * random.uniform());
        scene.camera.camera_to_world[3] = glm::dvec4(offset + 5.0 * size * random_point(random), 1);
        const PackedScene packed = pack_scene(scene);
        int exponent = 0;
        EXPECT_EQ(std::frexp(packed.placement.scale, &exponent), 0.5) << "a power of two";
        EXPECT_LT(glm::length(packed.placement.centre - offset), 2 * size) << "in the middle";
        float largest = 0;
        for (const LobeVertex& v : packed.vertices)
            for (const float c : {v.px, v.py, v.pz}) largest = std::max(largest, std::abs(c));
        for (const LobeSphere& s : packed.spheres)
            for (const float c : {s.x, s.y, s.z})
                largest = std::max(largest, std::abs(c) + s.radius);
        for (const float c : {packed.frame.eye_x, packed.frame.eye_y, packed.frame.eye_z})
            largest = std::max(largest, std::abs(c));
        EXPECT_LE(largest, 1.0000001f);
        EXPECT_GT(largest, 0.49f);
    }
}

// One point far away does not move the middle, so the rest keeps its precision.
TEST(BuildPlacement, OutliersDoNotMoveTheMiddle) {
    Scene scene = small_scene(0.5);
    Mesh ball = icosphere(2);
    ball.positions.push_back({1e7, 1e7, 1e7});
    add(scene, ball);
    EXPECT_LT(glm::length(place_scene(scene).centre), 1);
}

TEST(BuildPlacement, NothingAtAll) {
    const Placement placement = place_scene(Scene());
    EXPECT_EQ(placement.scale, 1);
    EXPECT_EQ(placement.point({1, 2, 3}), glm::dvec3(1, 2, 3));
}
