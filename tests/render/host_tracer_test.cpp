// SPDX-License-Identifier: Apache-2.0
// Pictures of whole scenes, by 8x8 blocks, against a path tracer that shares no code and no method.
#include <gtest/gtest.h>

#include "support/host_tracer.h"
#include "support/meshes.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double tests = 6;

// A room of five walls with a box, a ball and a lamp under the ceiling.
Scene room(std::uint32_t size) {
    Scene scene = small_scene(0.7, size, 60);
    scene.max_depth = 4;
    Mesh walls = cube();
    walls.triangles.erase(walls.triangles.begin(), walls.triangles.begin() + 2);  // z = -1 is open
    for (glm::dvec3& p : walls.positions) p = p + glm::dvec3(0, 0, 3);
    add(scene, walls);
    Mesh box = cube();
    for (glm::dvec3& p : box.positions) p = 0.3 * p + glm::dvec3(0.4, -0.7, 3.3);
    add(scene, box);
    add(scene, {-0.4, -0.6, 2.8}, 0.4);
    return scene;
}

}  // namespace

// The lamp hangs well below the ceiling: close to it, light samples have tails for which Student's
// distribution is wrong.
TEST(HostTracer, RoomWithATriangleLamp) {
    Scene scene = room(32);
    shine(add(scene, rectangle({-0.4, 0.6, 2.6}, {0.8, 0, 0}, {0, 0, 0.8})), 6, true);
    const Picture picture = render_picture(scene, {256});
    EXPECT_TRUE(blocks_agree(picture, trace_on_host(scene, 64, 1, false), tests));
    EXPECT_TRUE(blocks_agree(picture, trace_on_host(scene, 64, 2, true), tests));
}

TEST(HostTracer, RoomWithASphereLamp) {
    Scene scene = room(32);
    shine(add(scene, {0.1, 0.3, 2.7}, 0.3), 5);
    scene.point_lights.push_back({{-0.5, 0.7, 2.5}, glm::vec3(0.5f)});
    const Picture picture = render_picture(scene, {256});
    EXPECT_TRUE(blocks_agree(picture, trace_on_host(scene, 64, 3, true), tests));
}

// Half a sphere lamp stands in the floor and lamps cut one another: what a light's sampler sends
// may be hidden by the light itself.
TEST(HostTracer, LampsThatCutOtherShapes) {
    Scene scene = room(32);
    scene.environment = glm::vec3(0.1f, 0.2f, 0.3f);
    shine(add(scene, {0.1, -1, 2.7}, 0.4), 3);
    shine(add(scene, {0.3, -0.8, 2.6}, 0.35), 2, true);
    shine(add(scene, rectangle({-0.6, -1.2, 2.6}, {0, 0.9, 0}, {0, 0, 0.8})), 4, true);
    const Picture picture = render_picture(scene, {256});
    EXPECT_TRUE(blocks_agree(picture, trace_on_host(scene, 64, 4, true), tests));
}

TEST(HostTracer, SkySunAndLens) {
    Scene scene = small_scene(0.5, 32, 45);
    scene.max_depth = 3;
    look(scene, {0.3, 1, -1}, {0, 0, 4});
    scene.camera.lens_radius = 0.15;
    scene.camera.focal_distance = 4.5;
    scene.environment = glm::vec3(0.3f);
    add(scene, rectangle({-4, -1, -1}, {0, 0, 12}, {8, 0, 0}));
    add(scene, {-0.8, -0.2, 3}, 0.8);
    Mesh box = cube();
    for (glm::dvec3& p : box.positions) p = 0.5 * p + glm::dvec3(1, -0.4, 5);
    add(scene, box);
    scene.distant_lights.push_back({glm::normalize(glm::dvec3(-1, 2, -1)), glm::vec3(1.5f)});
    const Picture picture = render_picture(scene, {256});
    EXPECT_TRUE(blocks_agree(picture, trace_on_host(scene, 128, 5), tests));
}
