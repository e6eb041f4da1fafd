// SPDX-License-Identifier: Apache-2.0
// Where camera rays start and go, against the same camera in double.
#include <gtest/gtest.h>

#include <cmath>

#include "support/camera_rig.h"
#include "support/chi_square.h"
#include "base/random.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

std::vector<CameraNumbers> random_numbers(int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<CameraNumbers> all;
    for (int i = 0; i < count; ++i)
        all.push_back({random.uniform_float(), random.uniform_float(), random.uniform_float(),
                       random.uniform_float()});
    return all;
}

// The direction in camera space (z = 1) of a film point, for a square or oblong film.
glm::dvec3 camera_direction(const Scene& scene, double x, double y) {
    const double w = scene.film.width, h = scene.film.height, shorter = std::min(w, h);
    const double t = std::tan(scene.camera.fov * 3.14159265358979323846 / 360);
    return {(2 * x - w) / shorter * t, (h - 2 * y) / shorter * t, 1};
}

}  // namespace

TEST(CameraRays, PinholeSeesWhereThePixelIs) {
    for (const auto& [width, height] : {std::pair(64u, 64u), {64u, 48u}, {31u, 64u}})
        for (const double fov : {0.01, 30.0, 90.0, 170.0}) {
            Scene scene = small_scene(0.5);
            scene.film.width = width;
            scene.film.height = height;
            scene.camera.fov = fov;
            look(scene, {1, 2, 3}, {-2, 1, 9});
            const CameraRig rig(scene);
            for (const glm::uvec2 pixel : {glm::uvec2(0, 0), {width - 1, 3}, {7, height - 1}})
                for (const CameraSample& s : rig.sample(pixel, random_numbers(64, 1))) {
                    EXPECT_GE(s.film.x, pixel.x);
                    EXPECT_LT(s.film.x, pixel.x + 1);
                    EXPECT_EQ(s.weight, 1);
                    const glm::dvec3 way = glm::dmat3(scene.camera.camera_to_world) *
                                           camera_direction(scene, s.film.x, s.film.y);
                    EXPECT_LT(glm::length(glm::normalize(way) - glm::dvec3(s.direction)), 4e-7);
                    EXPECT_NEAR(glm::length(glm::dvec3(s.direction)), 1, 3e-7);
                }
        }
}

// A camera whose matrix scales its space looks the same way (pbrt allows it).
TEST(CameraRays, ScaledCameraSpaceIsNoZoom) {
    Scene scene = small_scene(0.5);
    look(scene, {1, 2, 3}, {-2, 1, 9});
    const auto plain = CameraRig(scene).sample({3, 5}, random_numbers(16, 2));
    scene.camera.camera_to_world = scene.camera.camera_to_world * glm::dmat4(glm::dmat3(3.0));
    const auto scaled = CameraRig(scene).sample({3, 5}, random_numbers(16, 2));
    for (std::size_t i = 0; i < plain.size(); ++i)
        EXPECT_LT(glm::length(plain[i].direction - scaled[i].direction), 4e-7f);
}

// All rays of one film point through the lens meet in the plane of focus, behind the pinhole's.
TEST(CameraRays, LensFocuses) {
    Scene scene = small_scene(0.5, 64, 40);
    look(scene, {1, 2, 3}, {-2, 1, 9});
    scene.camera.lens_radius = 0.3;
    scene.camera.focal_distance = 6;
    const CameraRig rig(scene);
    std::vector<CameraNumbers> numbers = random_numbers(1 << 14, 3);
    for (CameraNumbers& n : numbers) n[0] = 0.25f, n[1] = 0.75f;
    const glm::dvec3 eye(1, 2, 3), axis(glm::normalize(scene.camera.camera_to_world[2]));
    const double scale = rig.packed().placement.scale;
    const glm::dvec3 focus = eye + glm::dmat3(scene.camera.camera_to_world) *
                                       (6.0 * camera_direction(scene, 11.25, 40.75));
    std::vector<double> rings(16), sectors(16);
    for (const CameraSample& s : rig.sample({11, 40}, numbers)) {
        const glm::dvec3 origin = glm::dvec3(s.origin) / scale + rig.packed().placement.centre;
        const double t = glm::dot(focus - origin, axis) / glm::dot(glm::dvec3(s.direction), axis);
        ASSERT_LT(glm::length(origin + t * glm::dvec3(s.direction) - focus), 2e-5);
        const glm::dvec3 at = origin - eye;
        ASSERT_NEAR(glm::dot(at, axis), 0, 2e-6);
        const double r = glm::length(at) / 0.3;
        ASSERT_LE(r, 1 + 1e-5);
        const double angle = std::atan2(glm::dot(at, glm::dvec3(scene.camera.camera_to_world[1])),
                                        glm::dot(at, glm::dvec3(scene.camera.camera_to_world[0])));
        ++rings[std::min(15, int(16 * r * r))];
        ++sectors[std::min(15, int(16 * (angle / 6.283185307179586 + 0.5)))];
    }
    EXPECT_TRUE(follows(rings, std::vector<double>(16, 1), 2));
    EXPECT_TRUE(follows(sectors, std::vector<double>(16, 1), 2));
}

// A lens of radius zero is a pinhole, to the bit.
TEST(CameraRays, LensWithoutRadiusIsAPinhole) {
    Scene scene = small_scene(0.5);
    look(scene, {1, 2, 3}, {-2, 1, 9});
    const auto numbers = random_numbers(1 << 12, 4);
    const auto lens = CameraRig(scene, true).sample({9, 4}, numbers);
    const auto pinhole = CameraRig(scene, false).sample({9, 4}, numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        ASSERT_EQ(lens[i].origin, pinhole[i].origin);
        ASSERT_EQ(lens[i].direction, pinhole[i].direction);
        ASSERT_EQ(lens[i].film, pinhole[i].film);  // the box filter, from a table and without
        ASSERT_EQ(lens[i].weight, pinhole[i].weight);
    }
}
