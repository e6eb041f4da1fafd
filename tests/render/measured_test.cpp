// SPDX-License-Identifier: Apache-2.0
// Pictures of tables against pictures of the formulas that the tables were made from.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/measured.h"
#include "support/meshes.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

template <typename Value>
MeasuredBrdf tabulate(std::array<std::uint32_t, 3> counts, const Value& value) {
    MeasuredBrdf table{counts, {}};
    table.values.resize(std::size_t{counts[0]} * counts[1] * counts[2]);
    for (std::size_t cell = 0; cell < table.cells(); ++cell)
        table.values[cell] = glm::vec3(value(directions_at(table, cell)));
    return table;
}

// A ball on a floor under a lamp and a dim sky.
Scene ball_scene(const Material& material, const std::vector<float>& tables = {}) {
    Scene scene = small_scene(0.5, 24, 30);
    scene.max_depth = 3;
    scene.environment = glm::vec3(0.2f);
    scene.materials = {material};
    scene.tables = tables;
    add(scene, {0, 0, 4}, 0.9);
    add(scene, rectangle({-3, -0.9, 1}, {0, 0, 6}, {6, 0, 0}));
    shine(add(scene, {2, 3, 2}, 0.4), 20);
    return scene;
}

Picture picture_of(const MeasuredBrdf& table, std::uint64_t seed) {
    PictureOptions options;
    options.seed = seed;
    return render_picture(ball_scene(material("measured"), lay_out(table)), options);
}

}  // namespace

// Alone in a table, a diffuse part is sampled as Lambert's: path by path the same picture.
TEST(Measured, LambertsTableIsLambert) {
    const Picture lambert = render_picture(ball_scene(material("lambert")));
    const Picture table =
        picture_of(tabulate({6, 4, 5}, [](const DirectionPair&) { return glm::dvec3(0.25); }), 1);
    const FilmSums a = lambert.film.sums(), b = table.film.sums();
    double largest = 0;
    for (std::size_t i = 0; i < a.radiance.size(); ++i) {
        EXPECT_NEAR(a.radiance[i], b.radiance[i], 1e-5 * (1 + a.radiance[i])) << i;
        largest = std::max(largest, a.radiance[i]);
    }
    EXPECT_GT(largest, 1);
}

TEST(Measured, AGlossyTableIsItsFormula) {
    const auto glossy = [](const DirectionPair& pair) {
        const double c = glm::dot(glm::dvec3(-pair.wo.x, -pair.wo.y, pair.wo.z), pair.wi);
        return glm::dvec3(0.1 + 0.2 * std::pow(std::max(c, 0.0), 8));
    };
    const Picture formula = render_picture(
        ball_scene(material("modified_phong", {{"kd", 0.1f}, {"ks", 0.2f}, {"n", 8}})));
    const MeanOf exact = mean_of(formula);
    const MeanOf table = mean_of(picture_of(tabulate({64, 32, 48}, glossy), 2));
    EXPECT_TRUE(agrees(table, exact, 2, 2e-3));
    // The test sees a table of 2 % more.
    EXPECT_FALSE(agrees(
        mean_of(picture_of(
            tabulate({64, 32, 48}, [&](const DirectionPair& pair) { return 1.02 * glossy(pair); }),
            2)),
        exact, 2, 2e-3));
}
