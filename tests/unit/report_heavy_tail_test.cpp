// SPDX-License-Identifier: Apache-2.0
// The warning that error bars cannot be trusted: for rare bright samples, and not for pictures that
// are merely uneven.
#include "report/heavy_tail.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "support/film_blocks.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr std::uint32_t side = 100;

// `sample(pixel)` is one sample's radiance.
template <typename Sample>
Estimate picture(int blocks, const Sample& sample) {
    Film film(side, side);
    for (int b = 0; b < blocks; ++b) {
        std::vector<LobeBlockSum> sums(film.pixels() * LOBE_REPLICATES);
        for (std::size_t i = 0; i < sums.size(); ++i)
            for (int s = 0; s < LOBE_BLOCK / LOBE_REPLICATES; ++s) {
                const auto v = float(sample(i / LOBE_REPLICATES));
                sums[i].r += v, sums[i].g += v, sums[i].b += v;
            }
        add_block(film, sums, LOBE_BLOCK);
    }
    return estimate(film);
}

double pareto(Random& random, double alpha) { return std::pow(1 - random.uniform(), -1 / alpha); }

}  // namespace

TEST(HeavyTail, PlainNoiseIsLight) {
    Random random(1);
    for (const int blocks : {1, 8}) {
        const auto tail =
            error_tail(picture(blocks, [&](std::size_t) { return random.uniform(); }));
        ASSERT_TRUE(tail);
        EXPECT_FALSE(tail->heavy()) << tail->alpha;
    }
}

// A quiet picture with a noisy corner, and one whose noise grows smoothly a thousandfold.
TEST(HeavyTail, UnevenNoiseIsLight) {
    Random random(2);
    const auto corner = error_tail(picture(2, [&](std::size_t p) {
        return (p % side < 20 && p / side < 20 ? 50 : 1) * random.uniform();
    }));
    ASSERT_TRUE(corner);
    EXPECT_FALSE(corner->heavy()) << corner->alpha;
    const auto slope = error_tail(picture(2, [&](std::size_t p) {
        return std::pow(1000, double(p % side) / side) * random.uniform();
    }));
    ASSERT_TRUE(slope);
    EXPECT_FALSE(slope->heavy()) << slope->alpha;
}

TEST(HeavyTail, RareBrightSamplesAreHeavy) {
    Random random(3);
    for (const int blocks : {1, 8}) {
        const auto all =
            error_tail(picture(blocks, [&](std::size_t) { return pareto(random, 1.2); }));
        ASSERT_TRUE(all);
        EXPECT_TRUE(all->heavy()) << all->alpha;
        // One sample in a thousand is a firefly upon plain noise.
        const auto rare = error_tail(picture(blocks, [&](std::size_t) {
            const bool firefly = random.uniform() < 1e-3;
            return random.uniform() + (firefly ? 30 * pareto(random, 1.2) : 0);
        }));
        ASSERT_TRUE(rare);
        EXPECT_TRUE(rare->heavy()) << rare->alpha;
    }
}

TEST(HeavyTail, UnknownForSmallOrBlackPictures) {
    EXPECT_FALSE(error_tail(estimate(Film(4, 4))));
    EXPECT_FALSE(error_tail(picture(1, [](std::size_t) { return 0.0; })));
}
