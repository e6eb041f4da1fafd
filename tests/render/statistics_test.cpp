// SPDX-License-Identifier: Apache-2.0
// The counters of paths and light samples, in scenes where they are known.
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr std::uint32_t size = 24;  // a tile and parts of three
constexpr std::uint32_t samples = 12;
constexpr std::uint64_t paths = std::uint64_t{size} * size * samples;

RenderStatistics statistics_of(const Scene& scene, PictureOptions options = {}) {
    options.samples = samples;
    return render_picture(scene, options).statistics;
}

std::vector<std::uint64_t> counters(const RenderStatistics& statistics) {
    std::vector<std::uint64_t> all;
    for (unsigned i = 0; i < LOBE_STATISTIC_COUNT; ++i) all.push_back(statistics[i]);
    return all;
}

Scene wall_scene(double albedo) {
    Scene scene = small_scene(albedo, size, 60);
    scene.max_depth = 1;
    add(scene, wall(5, 20));
    return scene;
}

}  // namespace

// A convex body that fills the view, under a sky: one scattering event each, nothing to send for.
TEST(Statistics, WallUnderASky) {
    Scene scene = wall_scene(0.5);
    scene.environment = glm::vec3(1);
    const RenderStatistics s = statistics_of(scene);
    EXPECT_EQ(s.paths(), paths);
    EXPECT_EQ(s[LOBE_STATISTIC_ESCAPED], paths);
    EXPECT_EQ(s[LOBE_STATISTIC_DIRECTIONS], paths);
    EXPECT_EQ(s.paths_of_depth(1), paths);
    EXPECT_EQ(s.mean_depth(), 1);
    EXPECT_EQ(s.light_samples(), 0u);
    EXPECT_EQ(s.truncated_throughput(), 0);
}

TEST(Statistics, NothingIsScatteredAtDepthZero) {
    Scene scene = wall_scene(0.5);
    scene.max_depth = 0;
    scene.point_lights.push_back({{0, 0, 0}, glm::vec3(1)});
    const RenderStatistics s = statistics_of(scene);
    EXPECT_EQ(s[LOBE_STATISTIC_TRUNCATED], paths);
    EXPECT_EQ(s.paths_of_depth(0), paths);
    EXPECT_EQ(s[LOBE_STATISTIC_DIRECTIONS], 0u);
    EXPECT_EQ(s.light_samples(), 0u);
    EXPECT_EQ(s.mean_depth(), 0);
    EXPECT_EQ(s.truncated_throughput(), 1);
}

// Of a lamp before the wall all samples reach it; of one behind a board none does; of one behind
// the wall none is worth a shadow ray.
TEST(Statistics, LightSamplesByTheirFate) {
    const auto with_lamp_at = [](double z) {
        Scene scene = wall_scene(0.5);
        scene.point_lights.push_back({{0, 0, z}, glm::vec3(1)});
        return scene;
    };
    RenderStatistics s = statistics_of(with_lamp_at(1));
    EXPECT_EQ(s.light_samples(), paths);
    EXPECT_EQ(s[LOBE_STATISTIC_LIGHT_REACHED], paths);
    s = statistics_of(with_lamp_at(9));
    EXPECT_EQ(s.light_samples(), paths);
    EXPECT_EQ(s[LOBE_STATISTIC_LIGHT_USELESS], paths);
    Scene hidden = with_lamp_at(-9);
    add(hidden, wall(-8, 100));  // behind the camera
    s = statistics_of(hidden);
    EXPECT_EQ(s.light_samples(), paths);
    EXPECT_EQ(s[LOBE_STATISTIC_LIGHT_OCCLUDED], paths);
}

// Without the strategy that sends for shapes, only points are sent for.
TEST(Statistics, WhatIsNotSentForIsNotCounted) {
    Scene scene = wall_scene(0.5);
    shine(add(scene, {0, 9, 3}, 0.5), 5);
    PictureOptions options;
    options.integrator.strategy = Integrator::Strategy::brdf;
    EXPECT_EQ(statistics_of(scene, options).light_samples(), 0u);
    EXPECT_EQ(statistics_of(scene).light_samples(),
              statistics_of(scene)[LOBE_STATISTIC_DIRECTIONS]);
    scene.point_lights.push_back({{0, 0, 1}, glm::vec3(1)});
    const RenderStatistics s = statistics_of(scene, options);
    EXPECT_GT(s.light_samples(), 0u);
    EXPECT_LT(s.light_samples(), s[LOBE_STATISTIC_DIRECTIONS]);
}

// A black wall takes all; in a closed white room only the largest depth ends a path, with all of
// its throughput.
TEST(Statistics, EndsOfPaths) {
    RenderStatistics s = statistics_of(wall_scene(0));
    EXPECT_EQ(s[LOBE_STATISTIC_LOST], paths);
    EXPECT_EQ(s.mean_depth(), 0);
    const std::uint32_t depths[] = {1, 4, 5, 8, 9, 16, 17, 40};
    const unsigned bins[] = {1, 4, 5, 5, 6, 6, 7, 7};
    for (std::size_t i = 0; i < std::size(depths); ++i) {
        Scene room = small_scene(1, size);
        add(room, {0, 0, 0.5}, 2).flipped = true;
        room.max_depth = depths[i];
        s = statistics_of(room);
        EXPECT_EQ(s[LOBE_STATISTIC_TRUNCATED], paths) << depths[i];
        EXPECT_EQ(s.paths_of_depth(bins[i]), paths) << depths[i];
        EXPECT_EQ(s.mean_depth(), depths[i]);
        EXPECT_NEAR(s.truncated_throughput(), 1, 2.0 / LOBE_TRUNCATED_UNIT);
    }
    // Of two thirds after four events sixteen eighty-firsts are left, by chance or by weight.
    Scene room = small_scene(2 / 3.0, size);
    add(room, {0, 0, 0.5}, 2).flipped = true;
    room.max_depth = 4;
    s = statistics_of(room);
    EXPECT_NEAR(s.truncated_throughput(), 16 / 81.0, 0.02);
    EXPECT_GT(s[LOBE_STATISTIC_ROULETTE], 0u);
    EXPECT_EQ(s[LOBE_STATISTIC_ROULETTE] + s[LOBE_STATISTIC_TRUNCATED], paths);
}

TEST(Statistics, SumsAddUpHoweverTheRenderIsCut) {
    const Scene scene = busy_scene(size, true);
    const RenderStatistics s = statistics_of(scene);
    EXPECT_EQ(s.paths(), paths);
    std::uint64_t sum = 0;
    for (unsigned bin = 0; bin < LOBE_DEPTH_BINS; ++bin) sum += s.paths_of_depth(bin);
    EXPECT_EQ(sum, paths);
    EXPECT_EQ(s.light_samples(), s[LOBE_STATISTIC_DIRECTIONS]);
    for (const unsigned counter :
         {LOBE_STATISTIC_LIGHT_REACHED, LOBE_STATISTIC_LIGHT_OCCLUDED, LOBE_STATISTIC_LIGHT_USELESS,
          LOBE_STATISTIC_ESCAPED, LOBE_STATISTIC_LOST, LOBE_STATISTIC_ROULETTE,
          LOBE_STATISTIC_TRUNCATED})
        EXPECT_GT(s[counter], 0u) << counter;
    PictureOptions options;
    for (const std::uint32_t tiles : {1u, 3u}) {
        options.tiles_per_launch = tiles;
        EXPECT_EQ(counters(statistics_of(scene, options)), counters(s)) << tiles;
    }
    for (const std::array<unsigned, 2> local : {std::array<unsigned, 2>{1, 1}, {16, 4}, {3, 5}}) {
        options.local = local;
        EXPECT_EQ(counters(statistics_of(scene, options)), counters(s)) << local[0];
    }
    options = {};
    options.general = false;
    EXPECT_EQ(counters(statistics_of(scene, options)), counters(s)) << "only what is needed";
}
