// SPDX-License-Identifier: Apache-2.0
// Directional albedos of the glossy models, seen by rendering: a plane under an even sky of
// radiance 1, at one angle, one reflection. Values: quadrature of the closed forms, 40 digits.
#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Seen from far through a narrow view, so that the angle is one angle to a thousandth of a degree.
Picture plane_at(const std::string& model, float n, double degrees) {
    Scene scene = small_scene(0.5, 16, 0.002);
    scene.max_depth = 1;
    // Diffuse albedo 0.25, specular albedo 0.5 at normal incidence.
    scene.materials = {material(model, {{"kd", 0.25f}, {"ks", 0.5f}, {"n", n}, {"normalize", 1}})};
    scene.environment = glm::vec3(1);
    add(scene, rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
    const double a = degrees * 3.14159265358979323846 / 180;
    look(scene, 8.0 * glm::dvec3(std::sin(a), 0, std::cos(a)), {0, 0, 0});
    return render_picture(scene, {128});
}

struct Row {
    const char* model;
    float n;
    double albedo[4];  // at 0, 45, 80, 89 degrees
};

const Row furnace_rows[] = {
    {"rational", 0, {.75, .676777, .543412, .504363}},
    {"rational", 1, {.75, .627705, .454973, .413542}},
    {"rational", 10, {.75, .612310, .404693, .360011}},
    {"rational", 100, {.75, .607499, .374399, .324151}},
    {"rational", 1e3f, {.75, .605910, .360103, .303117}},
    {"rational", 1e5f, {.75, .604831, .349504, .283633}},
    {"modified_phong", 1, {.75, .627705, .454973, .413542}},
    {"modified_phong", 10, {.75, .603687, .364028, .315980}},
    {"modified_phong", 100, {.75, .603553, .337616, .274563}},
    {"modified_phong", 1e3f, {.75, .603553, .336824, .261606}},
    {"modified_phong", 1e5f, {.75, .603553, .336824, .258726}},
    {"phong", 1, {.75, .676777, .543412, .504363}},
    {"phong", 10, {.75, .748282, .607381, .511282}},
    {"phong", 100, {.75, .75, .730150, .534725}},
    {"phong", 1e3f, {.75, .75, .75, .604776}},
    {"phong", 1e5f, {.75, .75, .75, .75}},
};

}  // namespace

TEST(BrdfFurnace, AlbedosAreThoseOfTheTable) {
    const double angles[4] = {0, 45, 80, 89};
    for (const Row& row : furnace_rows)
        for (int i = 0; i < 4; ++i)
            // The table has six digits, the float angle a rounding.
            EXPECT_TRUE(agrees(mean_of(plane_at(row.model, row.n, angles[i])), row.albedo[i],
                               4 * std::size(furnace_rows), 3e-5))
                << row.model << ", n = " << row.n << ", " << angles[i] << " degrees";
}
