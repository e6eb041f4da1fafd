// SPDX-License-Identifier: Apache-2.0
#include "lab/plot/sphere_scene.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/error.h"
#include "base/log.h"

namespace lobe {
namespace {

// The floor's materials, light and dark; and around its squares.
constexpr double light = 0.55, dark = 0.2, plain = 0.375;
constexpr int squares = 14;  // each way from the middle
constexpr double side = 0.5;

const BrdfTable& matte(const std::vector<BrdfTable>& models) {
    const auto found = std::find_if(models.begin(), models.end(),
                                    [](const BrdfTable& m) { return m.name == "lambert"; });
    if (found == models.end())
        throw Error(ExitCode::device, "the kernels lack the model lambert, of which the floor is");
    return *found;
}

void add_square(Mesh& mesh, double x, double y, double half) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec2 c : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        mesh.positions.push_back({x + half * c.x, y + half * c.y, 0});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

// Squares of one colour, or the floor around them.
Mesh floor_squares(int colour) {
    Mesh mesh;
    for (int i = -squares; i < squares; ++i)
        for (int j = -squares; j < squares; ++j)
            if (((i + j) & 1) == colour)
                add_square(mesh, (i + 0.5) * side, (j + 0.5) * side, side / 2);
    return mesh;
}

Mesh floor_around() {
    Mesh mesh;
    const double edge = squares * side, far = 60;
    for (const double x : {-edge - far, edge + far}) add_square(mesh, x, 0, far);
    for (const double y : {-edge - far, edge + far}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::dvec2 c : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            mesh.positions.push_back({edge * c.x, y + far * c.y, 0});
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    return mesh;
}

Shape shape_of(std::variant<Mesh, Sphere> geometry, std::uint32_t material) {
    Shape shape;
    shape.geometry = std::move(geometry);
    shape.material = material;
    shape.where = "the sphere's scene";
    return shape;
}

}  // namespace

Scene sphere_scene(const Subject& subject, const std::vector<BrdfTable>& models,
                   std::uint32_t pixels) {
    Scene scene;
    const BrdfTable& floor = matte(models);
    for (const double albedo : {light, dark, plain})
        scene.materials.push_back({floor.name,
                                   brdf_rows(floor, {{"kd", albedo * glm::one_over_pi<double>()}}),
                                   floor.name, "the floor"});
    scene.materials.push_back({subject.model.name, subject.rows, subject.model.name, "the sphere"});
    scene.tables = subject.tables;
    scene.shapes.push_back(shape_of(floor_squares(0), 0));
    scene.shapes.push_back(shape_of(floor_squares(1), 1));
    scene.shapes.push_back(shape_of(floor_around(), 2));
    scene.shapes.push_back(shape_of(Sphere{{0, 0, 1}, 1}, 3));
    // x points to the left: camera space is left-handed.
    Shape lamp = shape_of(Sphere{{3, -3.2, 5.5}, 1}, 0);
    lamp.emission = Emission{glm::vec3(19, 18, 16), false};
    scene.shapes.push_back(lamp);
    scene.environment = glm::vec3(0.35f, 0.42f, 0.52f);
    scene.film.width = scene.film.height = pixels;
    scene.filter = {FilterKind::gaussian, 1.5, 1.5};
    scene.camera.fov = 25;
    scene.camera.camera_to_world = glm::inverse(
        glm::lookAtLH(glm::dvec3(0, -6.2, 2.6), glm::dvec3(0, 0, 0.92), glm::dvec3(0, 0, 1)));
    scene.max_depth = 6;
    return scene;
}

SpherePicture render_sphere(const Device& device, const KernelText& kernels,
                            const std::vector<BrdfTable>& models, const Subject& subject,
                            const SpherePlan& plan, const std::function<bool()>& stop) {
    PackOptions pack;
    pack.models = models;
    const PackedScene scene = pack_scene(sphere_scene(subject, models, plan.pixels), pack);
    Session session(device, kernels, scene);
    session.set_seed(plan.seed);
    RenderPlan samples;
    samples.samples = plan.samples;
    samples.stop = stop;
    const RenderOutcome outcome = render(session, samples);
    if (!session.status().sound())
        warn("samples of the sphere were not finite, negative or trapped", subject.model.name);
    return {estimate(outcome.film), outcome.seconds, outcome.stopped};
}

}  // namespace lobe
