// SPDX-License-Identifier: Apache-2.0
#include "support/scenes.h"

#include "scene/brdf_table.h"
#include "scene/transform.h"
#include "support/meshes.h"
#include "support/probe.h"
#include "support/trace_rig.h"

namespace lobe::test {

namespace {

constexpr double pi = 3.14159265358979323846;

Material lambert(double albedo) {
    const auto kd = static_cast<float>(albedo / pi);
    return {"lambert", {{{kd, kd, kd, 0}}}, "test", "test"};
}

}  // namespace

Material material(const std::string& model, const std::map<std::string, float>& values) {
    const std::string file = "brdf/" + model + ".h";
    const BrdfTable table = parse_brdf_table(file, test_kernels().read(file));
    auto rows = table.default_rows();
    for (const auto& [name, value] : values)
        rows.at(std::size_t(table.find(name))) = {value, value, value, 0};
    return {model, rows, "test", "test"};
}

Scene small_scene(double albedo, std::uint32_t size, double fov) {
    Scene scene;
    scene.film.width = scene.film.height = size;
    scene.camera.fov = fov;
    scene.materials.push_back(lambert(albedo));
    return scene;
}

Shape& add(Scene& scene, Mesh mesh) {
    scene.shapes.push_back(shape_of(std::move(mesh)));
    return scene.shapes.back();
}

Shape& add(Scene& scene, const glm::dvec3& centre, double radius) {
    scene.shapes.push_back(shape_of(Sphere{centre, radius}));
    return scene.shapes.back();
}

Shape& shine(Shape& shape, double radiance, bool two_sided) {
    shape.emission = Emission{glm::vec3(static_cast<float>(radiance)), two_sided};
    return shape;
}

Mesh wall(double distance, double half) {
    return rectangle({-half, -half, distance}, {0, 2 * half, 0}, {2 * half, 0, 0});
}

void look(Scene& scene, const glm::dvec3& eye, const glm::dvec3& target) {
    const glm::dvec3 way = target - eye;
    const glm::dvec3 up =
        std::abs(way.y) > 0.9 * glm::length(way) ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    scene.camera.camera_to_world = glm::inverse(*look_at(eye, target, up));
}

Scene busy_scene(std::uint32_t size, bool environment) {
    Scene scene = small_scene(0.6, size, 50);
    scene.materials.push_back(lambert(0.3));
    scene.camera.lens_radius = 0.05;
    scene.camera.focal_distance = 4;
    add(scene, rectangle({-3, -1, 0}, {0, 0, 8}, {6, 0, 0}));
    add(scene, wall(7, 3));
    Mesh box = cube();
    transform(box, rotation(30, {0, 1, 0}));
    for (glm::dvec3& p : box.positions) p = 0.5 * p + glm::dvec3(0.8, -0.5, 4.5);
    add(scene, box).material = 1;
    Mesh ball = icosphere(2);
    for (const glm::dvec3& p : ball.positions) ball.normals.push_back(glm::vec3(p));
    for (glm::dvec3& p : ball.positions) p = 0.4 * p + glm::dvec3(-0.2, 0.5, 4);
    add(scene, ball);
    add(scene, {-0.9, -0.4, 4}, 0.6).material = 1;
    shine(add(scene, {1.5, 1.5, 3}, 0.2), 30);
    shine(add(scene, rectangle({-1.6, 1.8, 3}, {0, 0, 1}, {-0.6, -0.5, 0})), 8, true);
    scene.point_lights.push_back({{0, 2, 1}, glm::vec3(3, 2, 1)});
    scene.distant_lights.push_back({glm::normalize(glm::dvec3(1, 2, -1)), glm::vec3(0.3f)});
    if (environment) scene.environment = glm::vec3(0.2f, 0.3f, 0.4f);
    return scene;
}

}  // namespace lobe::test
