// SPDX-License-Identifier: Apache-2.0
// The error bars, on films whose variance is known.
#include <gtest/gtest.h>

#include <cmath>

#include "base/statistics.h"
#include "report/estimate.h"
#include "support/chi_square.h"
#include "base/random.h"
#include "support/film_blocks.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Independent grey samples of a given mean and standard deviation, as the kernel would sum them.
Film noisy_film(std::uint32_t side, std::uint32_t samples, double level, double sd,
                Random& random) {
    Film film(side, side);
    for (std::uint32_t first = 0; first < samples; first += LOBE_BLOCK) {
        const std::uint32_t count = std::min<std::uint32_t>(LOBE_BLOCK, samples - first);
        std::vector<LobeBlockSum> sums(film.pixels() * LOBE_REPLICATES);
        for (std::size_t p = 0; p < film.pixels(); ++p)
            for (std::uint32_t s = first; s < first + count; ++s) {
                // Uniform, so that no sum of squares surprises.
                const auto v = float(level + sd * std::sqrt(12.0) * (random.uniform() - 0.5));
                LobeBlockSum& sum = sums[p * LOBE_REPLICATES + s % LOBE_REPLICATES];
                sum.r += v, sum.g += v, sum.b += v;
            }
        add_block(film, sums, count);
    }
    return film;
}

}  // namespace

TEST(ReportEstimate, ErrorsAreTheKnownOnes) {
    Random random(1);
    for (const std::uint32_t samples : {2u, 3u, 8u, 9u, 13u, 64u}) {
        const Estimate e = estimate(noisy_film(100, samples, 2, 0.5, random));
        const double exact = 0.5 / std::sqrt(samples);  // of one pixel
        ASSERT_EQ(e.standard_error.size(), 30000u);
        EXPECT_NEAR(e.mean, 2, 5 * exact / 100);
        EXPECT_NEAR(*e.mean_standard_error / (exact / 100), 1, 0.04) << samples << " samples";
        EXPECT_NEAR(*e.relative_standard_error / (exact / 2), 1, 0.04) << samples << " samples";
        double squares = 0;
        for (const float error : e.standard_error) squares += double(error) * error;
        EXPECT_NEAR(std::sqrt(squares / 30000) / exact, 1, 0.04) << samples << " samples";
    }
}

// Of the 95 % intervals of the image mean, 95 in 100 hold the truth.
TEST(ReportEstimate, IntervalsCover) {
    for (const std::uint32_t samples : {4u, 7u, 32u}) {
        Random random(samples);
        constexpr int trials = 2000;
        int held = 0;
        for (int i = 0; i < trials; ++i) {
            const Estimate e = estimate(noisy_film(8, samples, 1, 0.7, random));
            held += std::abs(e.mean - 1) <= student_quantile(0.975, 64) * *e.mean_standard_error;
        }
        EXPECT_TRUE(normal_deviate((held - 0.95 * trials) / std::sqrt(0.95 * 0.05 * trials), 3))
            << held << " of " << trials << " with " << samples << " samples";
    }
}

TEST(ReportEstimate, OneSampleKnowsNoError) {
    Random random(3);
    const Estimate one = estimate(noisy_film(4, 1, 2, 0.5, random));
    EXPECT_EQ(one.replicates, 1u);
    EXPECT_TRUE(one.standard_error.empty());
    EXPECT_FALSE(one.mean_standard_error);
    EXPECT_FALSE(one.relative_standard_error);
    EXPECT_EQ(error_text(one), "unknown");
    EXPECT_NEAR(one.mean, 2, 1);
    const Estimate none = estimate(Film(4, 4));
    EXPECT_EQ(none.samples, 0u);
    EXPECT_EQ(error_text(none), "unknown");
    EXPECT_EQ(none.rgb, std::vector<float>(48, 0));
}

// Pixels that saw a light are in the picture, but neither in its mean nor in its error.
TEST(ReportEstimate, LightsAreMasked) {
    Random random(4);
    Film film(10, 10), plain(10, 10);
    for (int i = 0; i < 4; ++i) {
        std::vector<LobeBlockSum> sums(100 * LOBE_REPLICATES);
        for (LobeBlockSum& s : sums) s.r = s.g = s.b = float(random.uniform(2, 3));
        add_block(plain, sums, LOBE_BLOCK);
        if (i == 2)  // one sample of one block saw it
            for (std::size_t k = 0; k < LOBE_REPLICATES; ++k)
                sums[7 * LOBE_REPLICATES + k].r = 1e6f;
        if (i == 2) sums[7 * LOBE_REPLICATES].emitter = 1;
        add_block(film, sums, LOBE_BLOCK);
    }
    const Estimate e = estimate(film), all = estimate(plain);
    EXPECT_EQ(e.masked, 1u);
    EXPECT_EQ(all.masked, 0u);
    EXPECT_GT(e.rgb[3 * 7], 1e4);
    double sum = 0, variance = 0;
    for (std::size_t p = 0; p < 100; ++p) {
        if (p == 7) continue;
        sum += all.rgb[3 * p];
        variance += std::pow(all.standard_error[3 * p], 2);
    }
    EXPECT_NEAR(e.mean, sum / 99, 1e-6);
    EXPECT_NEAR(*e.mean_standard_error, std::sqrt(variance) / 99, 1e-7);
    EXPECT_NEAR(*e.relative_standard_error, std::sqrt(variance / 99) / e.mean, 1e-6);
}

TEST(ReportEstimate, AllMaskedOrBlack) {
    Film film(2, 2);
    add_block(film, std::vector<LobeBlockSum>(4 * LOBE_REPLICATES, LobeBlockSum{1, 1, 1, 4}), 8);
    const Estimate lights = estimate(film);
    EXPECT_EQ(lights.masked, 4u);
    EXPECT_EQ(lights.mean, 0);
    EXPECT_FALSE(lights.relative_standard_error);
    Film black(2, 2);
    add_block(black, std::vector<LobeBlockSum>(4 * LOBE_REPLICATES), 8);
    EXPECT_EQ(*estimate(black).mean_standard_error, 0);
    EXPECT_FALSE(estimate(black).relative_standard_error);  // 0 / 0
}

TEST(ReportEstimate, HashKnowsEveryBit) {
    Random random(5);
    Estimate e = estimate(noisy_film(4, 8, 2, 0.5, random));
    const std::string first = image_hash(e);
    EXPECT_EQ(first.size(), 64u);
    e.standard_error[0] *= 2;  // not part of the picture
    EXPECT_EQ(image_hash(e), first);
    e.rgb[47] = std::nextafter(e.rgb[47], 9.0f);
    EXPECT_NE(image_hash(e), first);
}
