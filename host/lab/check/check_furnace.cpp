// SPDX-License-Identifier: Apache-2.0
// The albedo as the renderer finds it: a flat surface under a sky of radiance one, seen through a
// lens so long that every ray has the same angle.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "base/luminance.h"
#include "base/statistics.h"
#include "build/pack.h"
#include "lab/check/check_context.h"
#include "lab/measure/albedo.h"
#include "render/render.h"
#include "report/estimate.h"

namespace lobe {
namespace {

Scene furnace_scene(const BrdfTable& model, const BrdfRows& rows, const glm::dvec3& wo,
                    const std::vector<float>& tables, std::uint32_t pixels) {
    Scene scene;
    scene.materials.push_back({model.name, rows, model.name, "the furnace"});
    scene.tables = tables;
    Mesh floor;
    floor.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    floor.triangles = {{0, 1, 2}, {0, 2, 3}};
    Shape shape;
    shape.geometry = floor;
    shape.where = "the furnace";
    scene.shapes.push_back(shape);
    scene.environment = glm::vec3(1);
    scene.film.width = scene.film.height = pixels;
    scene.camera.fov = 1e-3;
    const glm::dvec3 up = std::abs(wo.z) > 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    scene.camera.camera_to_world = glm::inverse(glm::lookAtLH(4.0 * wo, glm::dvec3(0), up));
    scene.max_depth = 1;
    return scene;
}

}  // namespace

Finding check_furnace(CheckContext& context) {
    Finding finding("furnace");
    finding.note = "mean of a picture against quadrature";
    std::vector<BrdfRows> rows;
    const CheckEffort& effort = context.options.effort;
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < std::min(effort.furnace_sets, context.sets.size()); ++k)
        some.push_back(k * context.sets.size() / effort.furnace_sets);
    for (const std::size_t set : some) rows.push_back(context.sets[set].rows);
    context.probe.set_parameters(rows, context.tables);
    AlbedoEffort reckoning{effort.pilot, effort.cells, {}};
    reckoning.cubature.relative = 0.04 * effort.resolution;
    reckoning.cubature.nodes_a_job = effort.nodes;
    for (std::uint32_t set = 0; set < rows.size(); ++set) {
        for (const double degrees : effort.furnace_angles) {
            const glm::dvec3 wo = view_at(degrees);
            const Albedo reckoned = directional_albedos(context.probe, {{set, wo}}, reckoning)[0];
            const double albedo = luminance(reckoned.value);
            PackOptions pack;
            pack.all_features = true;
            pack.models = context.options.kernel_models;
            const PackedScene scene = pack_scene(
                furnace_scene(context.model, rows[set], wo, context.tables, effort.furnace_pixels),
                pack);
            Session session(context.device, context.kernels, scene);
            session.set_seed(context.options.seed);
            RenderPlan plan;
            plan.samples = effort.furnace_samples;
            const Estimate picture = estimate(render(session, plan).film);
            const std::string place =
                context.sets[some[set]].text + " at " + short_number(degrees) + " deg";
            const double error = std::hypot(picture.image_mean_standard_error.value_or(0),
                                            2e-4 * albedo, reckoned.error);
            if (!session.status().sound()) finding.see_p(0, place + ": the renderer trapped");
            // One degree of freedom a pixel and replicate beyond the first.
            const double freedom =
                double(effort.furnace_pixels) * effort.furnace_pixels * (LOBE_REPLICATES - 1);
            const double t = std::abs(picture.image_mean - albedo) / error;
            if (error > 0) finding.see_p(2 * student_cdf(-t, freedom), place);
        }
    }
    return finding;
}

}  // namespace lobe
