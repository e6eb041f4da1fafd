// SPDX-License-Identifier: Apache-2.0
// Closed rooms whose walls all shine alike: after d reflections of albedo a the radiance is the
// geometric sum of the emission, (1 - a^(d+1)) / (1 - a), wherever one looks and whatever the
// shape.
#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double tests = 24;

double closed_form(double albedo, unsigned depth) {
    return (1 - std::pow(albedo, depth + 1)) / (1 - albedo);
}

struct Room {
    const char* name;
    double albedo;
    unsigned depth;
    std::uint32_t samples;
};

const std::vector<Room> rooms = {{"black", 0, 5, 64},
                                 {"grey", 0.5, 3, 64},
                                 {"grey", 0.5, 40, 64},
                                 {"bright", 0.8, 200, 64},
                                 {"white", 0.99, 3000, 16}};

}  // namespace

TEST(Furnace, InsideAShiningSphere) {
    for (const bool two_sided : {false, true})
        for (const Room& room : rooms) {
            Scene scene = small_scene(room.albedo, 32);
            scene.max_depth = room.depth;
            Shape& sphere = shine(add(scene, {0.2, 0.1, -0.1}, 1), 1, two_sided);
            sphere.flipped = true;
            const Picture picture = render_picture(scene, {room.samples});
            EXPECT_TRUE(agrees(mean_of(picture), closed_form(room.albedo, room.depth), tests))
                << room.name << ", depth " << room.depth << (two_sided ? ", two-sided" : "");
        }
}

TEST(Furnace, InsideAShiningCube) {
    for (const Room& room : rooms) {
        Scene scene = small_scene(room.albedo, 32);
        scene.max_depth = room.depth;
        Mesh box = cube();
        for (glm::dvec3& p : box.positions) p.x += 0.3;
        shine(add(scene, box), 1).flipped = true;
        const Picture picture = render_picture(scene, {room.samples});
        EXPECT_TRUE(agrees(mean_of(picture), closed_form(room.albedo, room.depth), tests))
            << room.name << ", depth " << room.depth;
    }
}

// Walls that do not shine around a lamp: what the lamp gives is what the walls take. With albedo a
// a sphere's inside is lit evenly by a lamp at its middle: E = I / R^2 + a E, L = a E / pi.
TEST(Furnace, SphereAroundAPointLight) {
    for (const double albedo : {0.5, 0.8, 0.99}) {
        Scene scene = small_scene(albedo, 32);
        scene.max_depth = 3000;
        add(scene, {0, 0, 0.5}, 2).flipped = true;
        scene.point_lights.push_back({{0, 0, 0.5}, glm::vec3(4)});
        const Picture picture = render_picture(scene, {albedo > 0.9 ? 16u : 64u});
        const double irradiance = (4 / 4.0) / (1 - albedo);
        EXPECT_TRUE(agrees(mean_of(picture), albedo * irradiance / 3.14159265358979, tests))
            << "albedo " << albedo;
    }
}

// A body under an even sky reflects its albedo: to the last bits, since no sample varies.
TEST(Furnace, ConvexBodiesUnderAnEvenSky) {
    for (const double albedo : {0.18, 0.5, 1.0}) {
        Scene scene = small_scene(albedo, 32, 10);
        scene.environment = glm::vec3(1);
        add(scene, {0, 0, 5}, 1);
        const MeanOf sphere = mean_of(render_picture(scene, {16}));
        EXPECT_NEAR(sphere.mean, albedo, 3e-6) << "sphere";
        scene.shapes.clear();
        Mesh ball = icosphere(3);
        for (glm::dvec3& p : ball.positions) p.z += 5;
        add(scene, ball);
        EXPECT_NEAR(mean_of(render_picture(scene, {16})).mean, albedo, 3e-6) << "mesh";
    }
}
