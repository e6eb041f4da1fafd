// SPDX-License-Identifier: Apache-2.0
// The test of two pictures: how often it cries wolf, and what it sees.
#include "report/block_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "report/metrics.h"
#include "support/chi_square.h"

using namespace lobe;
using namespace lobe::test;

namespace {

enum class Noise { uniform, exponential, rare };

// A sample of mean 1.
double sample(Noise noise, Random& random) {
    switch (noise) {
        case Noise::uniform:
            return 2 * random.uniform();
        case Noise::exponential:
            return -std::log1p(-random.uniform());
        default:
            return random.uniform() < 0.02 ? 50 : 0;  // most pixels see nothing
    }
}

struct Picture {
    std::uint32_t width, height;
    std::vector<float> rgb, standard_error, luminance_error;
};

// Two replicates of `samples` / 2 each, as a render makes them; brightness differs from pixel to
// pixel, and the channels are correlated.
Picture render(std::uint32_t width, std::uint32_t height, int samples, Noise noise,
               Random& random) {
    Picture p{width, height, {}, {}, {}};
    for (std::uint32_t i = 0; i < width * height; ++i) {
        const double level = 0.1 + double(i % width) / width;
        double sums[2][3] = {};
        for (int s = 0; s < samples; ++s) {
            const double light = level * sample(noise, random);
            for (int c = 0; c < 3; ++c) sums[s % 2][c] += light * (1 + 0.2 * c * random.uniform());
        }
        for (int c = 0; c < 3; ++c) {
            p.rgb.push_back(float((sums[0][c] + sums[1][c]) / samples));
            p.standard_error.push_back(float(std::fabs(sums[0][c] - sums[1][c]) / samples));
        }
    }
    return p;
}

double p_same(const Picture& a, const Picture& b) {
    return *compare_pictures(view_of(a), view_of(b)).p_same;
}

}  // namespace

// At level 0.05 the whole verdict may be wrong in at most one of twenty cases, whatever the noise.
TEST(ReportBlockTest, FalseAlarmsAreRare) {
    for (const Noise noise : {Noise::uniform, Noise::exponential, Noise::rare})
        for (const auto& [a, b] : {std::pair{4, 4}, {2, 16}, {64, 64}}) {
            Random random(7);
            constexpr int trials = 400;
            int alarms = 0;
            for (int i = 0; i < trials; ++i) {
                const Picture first = render(40, 20, a, noise, random);
                alarms += p_same(first, render(40, 20, b, noise, random)) < 0.05;
            }
            // 0.05 * 400 = 20, standard deviation 4.4; with nine settings 32 is 2.8 of them.
            EXPECT_LE(alarms, 32) << int(noise) << ", " << a << " against " << b << " samples";
        }
}

// Image and blocks each hold their level where the noise is tame: not only careful, but right.
TEST(ReportBlockTest, LevelsAreRightForTameNoise) {
    Random random(8);
    constexpr int trials = 600;
    int image = 0, blocks = 0, chi_square = 0;
    for (int i = 0; i < trials; ++i) {
        const Picture a = render(40, 20, 16, Noise::uniform, random);
        const Picture b = render(40, 20, 16, Noise::uniform, random);
        const MeanTest t = *compare_pictures(view_of(a), view_of(b)).channels[1].test;
        image += t.image.p < 0.05;
        blocks += t.blocks_p < 0.05;
        chi_square += t.chi_square_p < 0.05;
    }
    for (const int alarms : {image, blocks, chi_square})
        EXPECT_TRUE(normal_deviate((alarms - 0.05 * trials) / std::sqrt(0.0475 * trials), 3))
            << alarms;
}

TEST(ReportBlockTest, SeesADimmerImageAndADimmerBlock) {
    Random random(9);
    const Picture a = render(48, 24, 64, Noise::uniform, random);
    Picture dimmer = render(48, 24, 64, Noise::uniform, random), patch = dimmer;
    EXPECT_GT(p_same(a, patch), 0.01);
    for (float& v : dimmer.rgb) v *= 0.97f;
    EXPECT_LT(p_same(a, dimmer), 1e-6);
    for (std::uint32_t y = 8; y < 16; ++y)  // the block at 40,8, a fifth darker in green
        for (std::uint32_t x = 40; x < 48; ++x) patch.rgb[3 * (48 * y + x) + 1] *= 0.8f;
    EXPECT_LT(p_same(a, patch), 1e-6);
    const PictureMetrics m = compare_pictures(view_of(a), view_of(patch));
    const MeanTest& test = *m.channels[2].test;
    EXPECT_EQ(test.worst.block.x, 40u);
    EXPECT_EQ(test.worst.block.y, 8u);
    EXPECT_EQ(test.worst.block.pixels, 64u);
    EXPECT_LT(test.chi_square_p, 1e-3);
    EXPECT_EQ(m.channels[2].worst_block.x, 40u);
    EXPECT_GT(m.channels[2].worst_block.difference, 0);
    EXPECT_EQ(test.blocks, 18u);
}

// Constant pixels know no error, and float sums of them differ in their last bits.
TEST(ReportBlockTest, RoundingIsNoDifference) {
    Picture a{16, 16, std::vector<float>(768, 0.3f), std::vector<float>(768, 0), {}}, b = a;
    for (float& v : b.rgb) v = std::nextafter(std::nextafter(v, 1.0f), 1.0f);
    EXPECT_EQ(p_same(a, b), 1);
    for (float& v : b.rgb) v *= 1 + 1e-6f;  // 17 units in the last place
    EXPECT_EQ(p_same(a, b), 0);
    for (float& e : b.standard_error) e = 1e-5f;
    EXPECT_EQ(compare_pictures(view_of(a), view_of(b)).channels[1].test->blocks, 4u);
}

// One pixel of K = 2 alone has one degree of freedom: Student's law there is Cauchy's.
TEST(ReportBlockTest, FreedomIsThatOfTheReplicates) {
    ChannelPair pair;
    pair.width = pair.height = 1;
    pair.place = {0};
    pair.picture = {4};
    pair.reference = {1};
    pair.picture_variance = {1};
    pair.reference_variance = {0};
    const auto blocks = test_blocks(pair, 8);
    ASSERT_EQ(blocks.size(), 1u);
    EXPECT_NEAR(blocks[0].deviation.freedom, 1, 1e-12);
    EXPECT_NEAR(blocks[0].deviation.p, 1 - 2 / 3.14159265358979 * std::atan(3.0), 1e-6);
    pair.picture_freedom = 3;
    EXPECT_NEAR(test_blocks(pair, 8)[0].deviation.freedom, 3, 1e-12);
    pair.picture_variance.clear();
    EXPECT_EQ(test_blocks(pair, 8)[0].deviation.p, 1);
    EXPECT_EQ(test_blocks(pair, 8)[0].deviation.difference, 3);
}

TEST(ReportBlockTest, LeastPOfMany) {
    EXPECT_NEAR(sidak_p(0.5, 2), 0.75, 1e-15);
    EXPECT_NEAR(sidak_p(1e-20, 1e4), 1e-16, 1e-20);
    EXPECT_EQ(sidak_p(1, 7), 1);
    EXPECT_EQ(sidak_p(0, 7), 0);
}
