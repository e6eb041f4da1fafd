// SPDX-License-Identifier: Apache-2.0
// Extreme scenes: finite pictures, no status counter raised (render_picture checks that), and right
// where the right answer is known.
#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double pi = 3.14159265358979323846;

bool all_finite(const Picture& picture) {
    for (const double value : picture.film.sums().radiance)
        if (!std::isfinite(value)) return false;
    return true;
}

Picture both_kernels(const Scene& scene, std::uint32_t samples = 16) {
    PictureOptions options;
    options.samples = samples;
    Picture general = render_picture(scene, options);
    options.general = false;
    EXPECT_EQ(render_picture(scene, options).hash, general.hash);
    EXPECT_TRUE(all_finite(general));
    return general;
}

}  // namespace

TEST(Extremes, EmptyScene) {
    Scene scene;
    scene.film.width = scene.film.height = 8;
    EXPECT_EQ(mean_of(both_kernels(scene)).mean, 0);
    scene.environment = glm::vec3(0.5f, 0.25f, 2);
    const Picture sky = both_kernels(scene);
    EXPECT_EQ(mean_of(sky, 0).mean, 0.5);
    EXPECT_EQ(mean_of(sky, 2).mean, 2);
}

TEST(Extremes, NoLightIsBlack) {
    Scene scene = small_scene(0.5);
    add(scene, {0, 0, 4}, 1);
    add(scene, wall(6, 3));
    EXPECT_EQ(mean_of(both_kernels(scene)).mean, 0);
    shine(scene.shapes[0], 0);  // a lamp that is off
    EXPECT_EQ(mean_of(both_kernels(scene)).mean, 0);
}

// A lamp without area shines on nothing and breaks nothing, beside one with area and alone.
TEST(Extremes, LampsWithoutArea) {
    Scene scene = small_scene(0.5);
    add(scene, wall(5, 9));
    Mesh flat;
    flat.positions = {{0, 2, 2}, {1, 2, 2}, {3, 2, 2}};
    flat.triangles = {{0, 1, 2}, {0, 0, 1}};
    shine(add(scene, flat), 100, true);
    EXPECT_EQ(mean_of(both_kernels(scene)).mean, 0);
    scene.distant_lights.push_back({{0, 0, -1}, glm::vec3(1)});
    EXPECT_TRUE(agrees(mean_of(both_kernels(scene)), 0.5 / pi, 1));
}

TEST(Extremes, RadianceOfManyMagnitudes) {
    for (const double radiance : {1e-30, 1e30}) {
        Scene scene = small_scene(0.5);
        add(scene, wall(5, 9));
        shine(add(scene, {0, 4, 3}, 0.5), radiance);
        const double mean = mean_of(both_kernels(scene)).mean;
        EXPECT_GT(mean, 1e-4 * radiance);
        EXPECT_LT(mean, radiance);
    }
}

// A lamp of radius 1e-6 in a scene of size ten gives the light of a point of its intensity.
TEST(Extremes, TinyLamp) {
    Scene scene = small_scene(0.5);
    scene.max_depth = 1;
    add(scene, wall(5, 9));
    Scene point = scene;
    shine(add(scene, {1, 1, 4}, 1e-6), 1e12);
    point.point_lights.push_back({{1, 1, 4}, glm::vec3(float(pi))});
    const MeanOf exact = mean_of(render_picture(point));
    EXPECT_TRUE(agrees(mean_of(both_kernels(scene, 64)), exact, 1, 1e-4));
}

// Everything a million units away from the origin of the world.
TEST(Extremes, FarFromTheOrigin) {
    const auto at = [](const glm::dvec3& offset) {
        Scene scene = small_scene(0.5);
        Mesh floor = wall(5, 9);
        for (glm::dvec3& p : floor.positions) p += offset;
        add(scene, floor);
        add(scene, glm::dvec3(0.3, 0.2, 3.5) + offset, 0.5);
        shine(add(scene, glm::dvec3(1, 2, 3) + offset, 0.5), 5);
        scene.camera.camera_to_world[3] = glm::dvec4(offset, 1);
        return scene;
    };
    const Picture near = render_picture(at(glm::dvec3(0)), {32});
    const Picture far = both_kernels(at({1048576, -2097152, 1048576}), 32);
    EXPECT_EQ(far.hash, near.hash);
    EXPECT_TRUE(blocks_agree(both_kernels(at({1e6, -3e6, 7e5}), 32), near, 1));
}

TEST(Extremes, CoincidentTriangles) {
    Scene scene = small_scene(0.5);
    scene.environment = glm::vec3(1);
    scene.max_depth = 1;
    Mesh stack;
    for (int i = 0; i < 200; ++i) {
        const Mesh one = wall(5, 9);
        const auto first = unsigned(stack.positions.size());
        stack.positions.insert(stack.positions.end(), one.positions.begin(), one.positions.end());
        for (const glm::uvec3& t : one.triangles) stack.triangles.push_back(t + first);
    }
    add(scene, stack);
    // The wall under half a sky: neither shadowed by its copies nor lit through them.
    EXPECT_NEAR(mean_of(both_kernels(scene)).mean, 0.5, 1e-5);
}

// Corners so far apart that their squares differ by forty orders of magnitude.
TEST(Extremes, MixedSizes) {
    Scene scene = small_scene(0.5, 16);
    scene.environment = glm::vec3(1);
    scene.max_depth = 1;
    Mesh plane = wall(5, 1);
    plane.positions = {{-1e9, -1e9, 5}, {0, 2e9, 5}, {1e9, -1e9, 5}};
    plane.triangles = {{0, 1, 2}};
    add(scene, plane);
    add(scene, {0.5, 0, 4}, 1e-9);
    EXPECT_TRUE(all_finite(both_kernels(scene)));
}

// A small ball on a floor a million times wider still touches its shadow: rays leave the floor
// where they should, not above the ball.
TEST(Extremes, WideFloorsKeepContactShadows) {
    const auto ball_on_floor = [](double half) {
        Scene scene = small_scene(0.5, 48, 30);
        scene.max_depth = 1;
        Mesh floor;
        floor.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
        floor.triangles = {{0, 1, 2}, {0, 2, 3}};
        add(scene, floor);
        add(scene, {0, 0, 0.3}, 0.3);
        scene.distant_lights.push_back({glm::normalize(glm::dvec3(1, 0, 1)), glm::vec3(2)});
        look(scene, {-1.5, -3, 2}, {-0.3, 0, 0.1});
        return mean_of(both_kernels(scene)).mean;
    };
    const double narrow = ball_on_floor(10);
    for (const double half : {1e3, 1e5, 1e6})
        EXPECT_NEAR(ball_on_floor(half), narrow, 0.005 * narrow) << half;
}
