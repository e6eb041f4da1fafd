// SPDX-License-Identifier: Apache-2.0
#include "study/bench/growth_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/transform.h"

namespace lobe {
namespace {

constexpr glm::dvec3 room{3, 3, 2};   // half of its size
constexpr double lamps_area = 1;      // of all together
constexpr double lamps_radiance = 8;  // of each

// Triangles that face down, in the cells of a square grid over the ceiling.
Mesh lamps(std::size_t count) {
    const auto across = static_cast<std::size_t>(std::ceil(std::sqrt(double(count))));
    const double cell = 2 * 0.9 * room.x / double(across);
    const double side = std::sqrt(2 * lamps_area / double(count));
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 corner(cell * (double(i % across) + 0.5) - 0.9 * room.x - side / 2,
                                cell * (double(i / across) + 0.5) - 0.9 * room.y - side / 2,
                                0.99 * room.z);
        const auto first = static_cast<unsigned>(mesh.positions.size());
        for (const glm::dvec3& p :
             {corner, corner + glm::dvec3(0, side, 0), corner + glm::dvec3(side, 0, 0)})
            mesh.positions.push_back(p);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

Shape shape_of(Mesh mesh) {
    Shape shape;
    shape.geometry = std::move(mesh);
    shape.where = "made in code";
    return shape;
}

}  // namespace

Mesh cube() {
    Mesh mesh;
    for (unsigned i = 0; i < 8; ++i)
        mesh.positions.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

Mesh bumpy_torus(unsigned around, unsigned across, double tube, double bumps) {
    Mesh mesh;
    constexpr double two_pi = glm::two_pi<double>();
    for (unsigned i = 0; i < around; ++i) {
        for (unsigned k = 0; k < across; ++k) {
            const double u = two_pi * i / around, v = two_pi * k / across;
            const double r = tube * (1 + bumps * std::sin(7 * u) * std::sin(5 * v));
            const double out = 1 + r * std::cos(v);
            mesh.positions.push_back({out * std::cos(u), out * std::sin(u), r * std::sin(v)});
            const unsigned next = (i + 1) % around, up = (k + 1) % across;
            const unsigned a = i * across + k, b = next * across + k;
            const unsigned c = next * across + up, d = i * across + up;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    }
    return mesh;
}

Mesh torus_in_a_room(std::size_t triangles) {
    const double across = std::sqrt(double(triangles) / 4);
    Mesh mesh = bumpy_torus(unsigned(2 * across), unsigned(across));
    const Mesh box = cube();
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (const glm::dvec3& p : box.positions) mesh.positions.push_back(room * p);
    for (const glm::uvec3& t : box.triangles) mesh.triangles.push_back(t + first);
    return mesh;
}

Scene torus_scene(std::size_t triangles, std::size_t lights, std::uint32_t width) {
    Scene scene;
    scene.path = "torus";
    scene.film.width = scene.film.height = width;
    scene.camera.fov = 60;
    scene.camera.camera_to_world =
        glm::inverse(*look_at({0.6, -2.8, 1.2}, {0, 0, -0.2}, {0, 0, 1}));
    const auto reflectance = static_cast<float>(0.6 / glm::pi<double>());
    scene.materials.push_back(
        {"lambert", {{{reflectance, reflectance, reflectance, 0}}}, "matte", "made in code"});
    scene.shapes.push_back(shape_of(torus_in_a_room(triangles)));
    scene.shapes.push_back(shape_of(lamps(lights)));
    scene.shapes.back().emission = Emission{glm::vec3(float(lamps_radiance)), false};
    return scene;
}

}  // namespace lobe
