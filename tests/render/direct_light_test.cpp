// SPDX-License-Identifier: Apache-2.0
// One reflection of each kind of light off a wall, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/meshes.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double tests = 40;
constexpr double albedo = 0.6;
constexpr double distance_to_wall = 5;

// A wall at z = 5 that fills the view, one reflection.
Scene wall_scene(std::uint32_t size = 32) {
    Scene scene = small_scene(albedo, size, 60);
    scene.max_depth = 1;
    add(scene, wall(distance_to_wall, 20));
    return scene;
}

// Mean over the picture of the radiance that the wall reflects, given its irradiance at (x, y).
double wall_mean(const std::function<double(double, double)>& irradiance) {
    constexpr int steps = 600;
    const double half = distance_to_wall * std::tan(30 * pi / 180);
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k)
            sum +=
                irradiance(half * (2 * (i + 0.5) / steps - 1), half * (2 * (k + 0.5) / steps - 1));
    return albedo / pi * sum / (double(steps) * steps);
}

glm::dvec3 on_wall(double x, double y) { return {x, y, distance_to_wall}; }
const glm::dvec3 towards_camera(0, 0, -1);

// Of a sphere of radiance 1, wholly above the horizon: pi sin^2 of its half angle times the cosine.
double sphere_irradiance(const glm::dvec3& point, const glm::dvec3& centre, double radius) {
    const glm::dvec3 way = centre - point;
    const double squared = glm::dot(way, way);
    return pi * radius * radius / squared * glm::dot(way, towards_camera) / std::sqrt(squared);
}

// Of a polygon of radiance 1, wholly above the horizon: Lambert's formula.
double polygon_irradiance(const glm::dvec3& point, const std::vector<glm::dvec3>& corners) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::normalize(corners[i] - point);
        const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()] - point);
        const glm::dvec3 across = glm::cross(a, b);
        const double sine = glm::length(across);
        if (sine > 0) sum += std::atan2(sine, glm::dot(a, b)) * across / sine;
    }
    return std::abs(glm::dot(sum, towards_camera)) / 2;
}

// A lamp outside the view must not hide the wall from the camera: these stand above or beside it.
const std::vector<glm::dvec3> triangle = {{-3.5, 1, 3}, {-3.2, -2, 3.5}, {-3.4, 0.5, 1}};

}  // namespace

TEST(DirectLight, Point) {
    for (const glm::dvec3& at : {glm::dvec3(0, 0, 4), glm::dvec3(4, 1, 2), glm::dvec3(0, 9, 4.9)}) {
        Scene scene = wall_scene();
        scene.point_lights.push_back({at, glm::vec3(7)});
        const double exact = wall_mean([&](double x, double y) {
            const glm::dvec3 way = at - on_wall(x, y);
            const double squared = glm::dot(way, way);
            return 7 * glm::dot(way, towards_camera) / (squared * std::sqrt(squared));
        });
        EXPECT_TRUE(agrees(mean_of(render_picture(scene)), exact, tests, 2e-5));
    }
}

TEST(DirectLight, Distant) {
    for (const double angle : {0.0, 45.0, 85.0}) {
        Scene scene = wall_scene();
        const double a = angle * pi / 180;
        scene.distant_lights.push_back({{std::sin(a), 0, -std::cos(a)}, glm::vec3(3)});
        const double exact = albedo / pi * 3 * std::cos(a);
        EXPECT_TRUE(agrees(mean_of(render_picture(scene, {8})), exact, tests)) << angle;
    }
    // From behind the wall nothing comes through.
    Scene scene = wall_scene();
    scene.distant_lights.push_back({{0, 0, 1}, glm::vec3(3)});
    EXPECT_EQ(mean_of(render_picture(scene, {8})).mean, 0);
}

TEST(DirectLight, Sphere) {
    for (const double radius : {1e-6, 1e-3, 0.1, 0.9})
        for (const glm::dvec3& at : {glm::dvec3(3.6, 0, 4), glm::dvec3(0, -6, 2)}) {
            Scene scene = wall_scene();
            shine(add(scene, at, radius), 1 / (radius * radius));
            const double exact = wall_mean([&](double x, double y) {
                return sphere_irradiance(on_wall(x, y), at, radius) / (radius * radius);
            });
            EXPECT_TRUE(agrees(mean_of(render_picture(scene)), exact, tests, 2e-5))
                << "radius " << radius;
        }
}

TEST(DirectLight, Triangle) {
    for (const bool flipped : {false, true}) {
        Scene scene = wall_scene();
        Mesh mesh;
        mesh.positions = triangle;
        mesh.triangles = {{0, 1, 2}};
        if (flipped) std::swap(mesh.triangles[0].y, mesh.triangles[0].z);
        shine(add(scene, mesh), 5).flipped = flipped;
        const double exact = 5 * wall_mean([](double x, double y) {
                                 return polygon_irradiance(on_wall(x, y), triangle);
                             });
        const MeanOf front = mean_of(render_picture(scene));
        scene.shapes.back().flipped = !flipped;
        const MeanOf back = mean_of(render_picture(scene));
        const bool lit = front.mean > back.mean;
        EXPECT_TRUE(agrees(lit ? front : back, exact, tests));
        EXPECT_EQ((lit ? back : front).mean, 0);
        scene.shapes.back().emission->two_sided = true;
        EXPECT_TRUE(agrees(mean_of(render_picture(scene)), exact, tests));
    }
}

// A lamp that hangs just before a board, and one just behind: only what is before it hides it.
TEST(DirectLight, LampsCloseToABoard) {
    Mesh lamp;
    lamp.positions = triangle;
    lamp.triangles = {{0, 1, 2}};
    const glm::dvec3 normal =
        glm::normalize(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
    const double lit = 5 * wall_mean([](double x, double y) {
                           return polygon_irradiance(on_wall(x, y), triangle);
                       });
    for (const double gap : {2e-4, -2e-3}) {  // along the side that looks away from the wall
        Scene scene = wall_scene();
        shine(add(scene, lamp), 5, true);
        Mesh board = lamp;
        const glm::dvec3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
        const double away = glm::dot(normal, middle - on_wall(0, 0)) > 0 ? 1 : -1;
        for (glm::dvec3& p : board.positions) p = middle + 4.0 * (p - middle) + away * gap * normal;
        add(scene, board);
        const MeanOf mean = mean_of(render_picture(scene));
        if (gap > 0) {
            EXPECT_TRUE(agrees(mean, lit, tests));
        } else {
            EXPECT_EQ(mean.mean, 0);
        }
    }
}

TEST(DirectLight, SeveralLightsAdd) {
    Scene scene = wall_scene();
    const glm::dvec3 ball(0, -6, 2), lamp(4, 1, 2);
    shine(add(scene, ball, 0.5), 3);
    Mesh mesh;
    mesh.positions = triangle;
    mesh.triangles = {{0, 1, 2}};
    shine(add(scene, mesh), 5, true);
    scene.point_lights.push_back({lamp, glm::vec3(7)});
    scene.distant_lights.push_back({{0, 0.6, -0.8}, glm::vec3(0.5f)});
    scene.environment = glm::vec3(0.25f);
    // Lamps hide their part of the sky; the shadows that they throw fall outside the picture.
    const double exact = wall_mean([&](double x, double y) {
        const glm::dvec3 p = on_wall(x, y), way = lamp - p;
        const double squared = glm::dot(way, way);
        return (3 - 0.25) * sphere_irradiance(p, ball, 0.5) +
               (5 - 0.25) * polygon_irradiance(p, triangle) +
               7 * glm::dot(way, towards_camera) / (squared * std::sqrt(squared)) + 0.5 * 0.8 +
               0.25 * pi;
    });
    EXPECT_TRUE(agrees(mean_of(render_picture(scene, {256})), exact, tests));
}

// Each strategy alone against both together: a sky is found by chance alone, the same sky as a
// shining sphere around the scene by chance and by choice; a point is found by choice alone, the
// same light as a tiny sphere by both.
TEST(DirectLight, StrategiesAgree) {
    Scene by_chance = small_scene(albedo, 32, 60);
    by_chance.max_depth = 3;
    add(by_chance, rectangle({-2, -1, 1}, {0, 0, 4}, {4, 0, 0}));
    add(by_chance, {0.3, -0.2, 3}, 0.8);
    Scene by_both = by_chance;
    by_chance.environment = glm::vec3(1);
    by_both.materials.push_back({"lambert", {{{0, 0, 0, 0}}}, "test", "test"});
    Shape& sky = shine(add(by_both, {0, 0, 0}, 50), 1);
    sky.flipped = true;
    sky.material = 1;
    EXPECT_TRUE(
        blocks_agree(render_picture(by_chance, {128}), render_picture(by_both, {128, 2}), tests));

    Scene by_choice = by_chance;
    by_choice.environment.reset();
    Scene by_sphere = by_choice;
    by_choice.point_lights.push_back({{1, 2, 0.5}, glm::vec3(float(0.01 * 0.01 * pi * 900))});
    shine(add(by_sphere, {1, 2, 0.5}, 0.01), 900);
    EXPECT_TRUE(
        blocks_agree(render_picture(by_choice, {128}), render_picture(by_sphere, {128, 2}), tests));
}
