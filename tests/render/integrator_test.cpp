// SPDX-License-Identifier: Apache-2.0
// The integrator's choices change the noise of a picture and not what it converges to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/meshes.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

using Sampler = Integrator::Sampler;
using Strategy = Integrator::Strategy;
using Heuristic = Integrator::Heuristic;
using Directions = Integrator::Directions;

// All that differ: without two strategies there is nothing to weigh.
std::vector<Integrator> all_choices() {
    std::vector<Integrator> all;
    for (const Sampler sampler : {Sampler::sobol, Sampler::independent})
        for (const Directions directions : {Directions::matched, Directions::cosine}) {
            all.push_back({sampler, Strategy::both, Heuristic::power, directions});
            all.push_back({sampler, Strategy::both, Heuristic::balance, directions});
            all.push_back({sampler, Strategy::light, Heuristic::power, directions});
            all.push_back({sampler, Strategy::brdf, Heuristic::power, directions});
        }
    return all;
}

// Every kind of light over glossy and matte shapes. The lamps are large enough for scattering to
// find them, so that a few hundred samples make a normal mean.
Scene glossy_scene() {
    Scene scene = small_scene(0.5, 16, 50);
    scene.max_depth = 4;
    scene.materials.push_back(
        material("rational", {{"kd", 0.1f}, {"ks", 0.5f}, {"n", 20}, {"normalize", 0}}));
    scene.materials.push_back(
        material("modified_phong", {{"kd", 0.1f}, {"ks", 0.8f}, {"n", 12}, {"normalize", 0}}));
    add(scene, rectangle({-3, -1, 0}, {0, 0, 8}, {6, 0, 0})).material = 1;
    add(scene, wall(7, 3));
    add(scene, {-0.9, -0.4, 4}, 0.6).material = 2;
    add(scene, {0.6, -0.5, 4}, 0.5);
    shine(add(scene, {1.2, 1.2, 3.5}, 0.6), 5);
    shine(add(scene, rectangle({-2, 2, 3}, {0, 0, 2}, {2, 0, 0})), 3, true);
    scene.point_lights.push_back({{0, 2, 1}, glm::vec3(2, 2, 2)});
    scene.distant_lights.push_back({glm::normalize(glm::dvec3(1, 2, -1)), glm::vec3(0.3f)});
    scene.environment = glm::vec3(0.2f);
    return scene;
}

Picture picture_by(const Scene& scene, const Integrator& integrator, std::uint32_t samples,
                   std::uint64_t seed) {
    PictureOptions options;
    options.samples = samples;
    options.seed = seed;
    options.general = false;
    options.integrator = integrator;
    return render_picture(scene, options);
}

class Choices : public testing::TestWithParam<std::size_t> {};

}  // namespace

TEST_P(Choices, ConvergeToTheSamePicture) {
    const std::vector<Integrator> choices = all_choices();
    const Integrator& integrator = choices[GetParam()];
    const Scene scene = glossy_scene();
    const Picture usual = picture_by(scene, {}, 2048, 1);
    EXPECT_TRUE(blocks_agree(picture_by(scene, integrator, 512, 2 + GetParam()), usual,
                             double(choices.size())))
        << to_text(integrator);
}
INSTANTIATE_TEST_SUITE_P(Integrator, Choices, testing::Range<std::size_t>(0, 16));

// A choice that the kernel did not honour would pass above.
TEST(Integrator, EveryChoiceIsOneOfItsOwn) {
    const Scene scene = glossy_scene();
    std::vector<std::string> hashes;
    for (const Integrator& integrator : all_choices())
        hashes.push_back(picture_by(scene, integrator, 8, 1).hash);
    std::sort(hashes.begin(), hashes.end());
    EXPECT_EQ(std::unique(hashes.begin(), hashes.end()), hashes.end());
}

// What only one way can find is found whatever the strategy: a lamp in a mirror, a point light.
TEST(Integrator, WhatOneWayAloneFindsIsNeverLost) {
    Scene scene = small_scene(0.5, 16, 50);
    scene.max_depth = 1;
    scene.materials.push_back(
        material("rational", {{"kd", 0}, {"ks", 0.5f}, {"n", INFINITY}, {"normalize", 1}}));
    add(scene, wall(4, 20)).material = 1;
    shine(add(scene, {0, 0, -4}, 2), 3);
    const MeanOf mirrored = mean_of(picture_by(scene, {}, 64, 1));
    EXPECT_GT(mirrored.mean, 0.01);
    for (const Strategy strategy : {Strategy::light, Strategy::brdf}) {
        Integrator integrator;
        integrator.strategy = strategy;
        EXPECT_TRUE(agrees(mean_of(picture_by(scene, integrator, 64, 2)), mirrored, 4));
    }
    scene.shapes.pop_back();
    scene.shapes.front().material = 0;
    scene.point_lights.push_back({{0, 0, 1}, glm::vec3(3)});
    const MeanOf lit = mean_of(picture_by(scene, {}, 64, 1));
    EXPECT_GT(lit.mean, 0.01);
    for (const Strategy strategy : {Strategy::light, Strategy::brdf}) {
        Integrator integrator;
        integrator.strategy = strategy;
        EXPECT_TRUE(agrees(mean_of(picture_by(scene, integrator, 64, 2)), lit, 4));
    }
}
