// SPDX-License-Identifier: Apache-2.0
// Samples where the error is: the mean of the picture stays what it is, and the error falls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "render/render.h"
#include "report/adaptive.h"
#include "report/error_target.h"
#include "report/estimate.h"
#include "support/chi_square.h"
#include "support/device.h"
#include "support/probe.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// A glossy ball and a small bright light over a matte wall: noisy in one place, quiet elsewhere.
Scene uneven_scene(std::uint32_t size) {
    Scene scene = small_scene(0.6, size);
    add(scene, wall(6, 5));
    scene.materials.push_back(
        material("rational", {{"n", 100}, {"kd", 0.1f}, {"ks", 0.6f}, {"normalize", 1}}));
    add(scene, {0.8, 0.8, 4}, 0.9).material = 1;
    shine(add(scene, {-3, 3.4, 3}, 0.06), 800);  // out of sight
    return scene;
}

// The scene on the test device.
struct Rig {
    explicit Rig(std::uint32_t size)
        : packed(pack_scene(uneven_scene(size), {read_brdf_tables(test_kernels())})),
          session(test_device(), test_kernels(), packed) {}

    Film film(std::uint64_t seed, std::uint32_t samples, std::vector<float> rates = {}) {
        session.set_seed(seed);
        RenderPlan plan;
        plan.samples = samples;
        plan.rates = std::move(rates);
        return std::move(render(session, plan).film);
    }

    Film adaptive_film(std::uint64_t seed, std::uint32_t samples) {
        return film(seed, samples, tile_rates(film(pilot_seed(seed), 16)));
    }

    PackedScene packed;
    Session session;
};

}  // namespace

// Over many seeds the mean is that of a long even render, and the intervals hold it.
TEST(Adaptive, MeansAreUnbiased) {
    Rig rig(48);
    const Estimate truth = estimate(rig.film(1000001, 16384));
    constexpr int seeds = 300;
    std::vector<double> means;
    int held = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        const Estimate e = estimate(rig.adaptive_film(seed, 16));
        means.push_back(e.image_mean);
        held += std::abs(e.image_mean - truth.image_mean) <
                normal_quantile(0.975) *
                    std::hypot(*e.image_mean_standard_error, *truth.image_mean_standard_error);
    }
    const double error = std::hypot(standard_error(means), *truth.image_mean_standard_error);
    EXPECT_TRUE(normal_deviate((mean(means) - truth.image_mean) / error, 2))
        << mean(means) << " +- " << error << " of " << truth.image_mean;
    EXPECT_GE(held, seeds * 0.90);
    EXPECT_LE(held, seeds * 0.99);
}

TEST(Adaptive, ErrorsAreSmaller) {
    Rig rig(96);
    const Film even = rig.film(1, 64), adaptive = rig.adaptive_film(1, 64);
    EXPECT_NEAR(adaptive.mean_samples(), 64, 4);
    EXPECT_LT(*estimate(adaptive).relative_standard_error,
              0.9 * *estimate(even).relative_standard_error);
    const Estimate e = estimate(adaptive);
    EXPECT_LT(e.samples, 64u);
    EXPECT_GT(*std::max_element(e.sample_counts.begin(), e.sample_counts.end()), 64u);
}

// A tile's samples are those of an even render, as many as it has.
TEST(Adaptive, TilesTakeTheSameSamplesWhateverTheirRate) {
    Rig rig(48);
    std::vector<float> rates(9, 0.5f);
    rates[4] = 5;
    const Film uneven = rig.film(3, 16, rates);
    const Film few = rig.film(3, 8), many = rig.film(3, 80);
    for (std::uint32_t t = 0; t < 9; ++t) {
        const Film& same = t == 4 ? many : few;
        ASSERT_EQ(uneven.tile_samples(t), t == 4 ? 80u : 8u);
        const PixelBox box = uneven.tile_box(t);
        const std::size_t p = std::size_t{box.y + 3} * 48 + box.x + 5;
        EXPECT_EQ(uneven.sums().radiance[p * 3 * LOBE_REPLICATES],
                  same.sums().radiance[p * 3 * LOBE_REPLICATES]);
    }
}

// Stopping at an error, as a render does: the picture's true error is the stated one, and a rule
// that looks at the samples it keeps leaves the mean what it is.
TEST(ErrorTarget, StoppingIsHonest) {
    Rig rig(48);
    const Estimate truth = estimate(rig.film(1000001, 16384));
    constexpr double target = 0.004;
    constexpr int seeds = 20;
    std::vector<double> means, errors;
    for (int seed = 1; seed <= seeds; ++seed) {
        ErrorTarget rule(target);
        rig.session.set_seed(seed);
        RenderPlan plan;
        plan.samples = 100000;
        plan.next_samples = [&](const Film& f, std::uint32_t wanted) {
            return rule.met(f) ? 0 : wanted;
        };
        const Estimate e = estimate(render(rig.session, plan).film);
        double squares = 0;
        std::size_t count = 0;
        for (std::size_t p = 0; p < e.rgb.size() / 3; ++p) {
            if (e.sees_light[p] || truth.sees_light[p]) continue;
            squares += std::pow(double(e.rgb[3 * p]) - truth.rgb[3 * p], 2);  // all grey
            ++count;
        }
        errors.push_back(std::sqrt(squares / double(count)) / truth.mean);
        means.push_back(e.image_mean);
    }
    EXPECT_LT(mean(errors), target);
    EXPECT_GT(mean(errors), target * 0.90);
    const double error = std::hypot(standard_error(means), *truth.image_mean_standard_error);
    EXPECT_TRUE(normal_deviate((mean(means) - truth.image_mean) / error, 1))
        << mean(means) << " +- " << error << " of " << truth.image_mean;
}
