// SPDX-License-Identifier: Apache-2.0
// Rates of tiles, from pilots whose noise is known.
#include "report/adaptive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "support/film_blocks.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr std::uint32_t tiles = 6, side = tiles * LOBE_TILE;

// Noise of deviation 1, and of `loud` in the left half; with `lit` the left half sees lights.
Film pilot(double loud, bool lit = false) {
    Random random(1);
    Film film(side, side);
    for (int block = 0; block < 2; ++block) {
        std::vector<LobeBlockSum> sums(film.pixels() * LOBE_REPLICATES);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const bool left = i / LOBE_REPLICATES % side < side / 2;
            const auto v = float(10 + (left ? loud : 1) * (random.uniform() - 0.5));
            sums[i] = {v, v, v, left && lit ? 1.0f : 0.0f};
        }
        add_block(film, sums, LOBE_BLOCK);
    }
    return film;
}

double mean_of(const std::vector<float>& rates) {
    double sum = 0;
    for (const float rate : rates) sum += rate;
    return sum / double(rates.size());
}

}  // namespace

TEST(Adaptive, EvenNoiseGetsEvenRates) {
    for (const float rate : tile_rates(pilot(1))) EXPECT_NEAR(rate, 1, 0.15);
}

// Four times the deviation: nearly four times the samples, less what is mixed in of others.
TEST(Adaptive, NoisyTilesGetMore) {
    const std::vector<float> rates = tile_rates(pilot(4));
    ASSERT_EQ(rates.size(), tiles * tiles);
    EXPECT_NEAR(mean_of(rates), 1, 1e-4);
    const float loud = rates[tiles + 1], quiet = rates[2 * tiles - 2];  // far from the border
    EXPECT_GT(loud / quiet, 2.2);
    EXPECT_LT(loud / quiet, 4);
    const float near = rates[tiles + tiles / 2];  // quiet beside the noise
    EXPECT_GT(near, quiet);
}

TEST(Adaptive, RatesStayWithinBounds) {
    for (const float rate : tile_rates(pilot(1e6))) {
        EXPECT_GE(rate, 0.125f);
        EXPECT_LE(rate, 8.0f);
    }
}

// What is masked in the error gets no samples for it.
TEST(Adaptive, LightsAreNoNoise) {
    const std::vector<float> rates = tile_rates(pilot(100, true));
    EXPECT_LT(rates[tiles + 0], rates[2 * tiles - 2]);
}

TEST(Adaptive, BlackOrUnknownIsEven) {
    Film black(side, side);
    EXPECT_EQ(tile_rates(black), std::vector<float>(tiles * tiles, 1.0f));
    add_block(black, std::vector<LobeBlockSum>(black.pixels() * LOBE_REPLICATES), LOBE_BLOCK);
    EXPECT_EQ(tile_rates(black), std::vector<float>(tiles * tiles, 1.0f));
}

TEST(Adaptive, PilotsAreWholeBlocksOfAnotherSeed) {
    EXPECT_EQ(pilot_samples(0), 16u);
    EXPECT_EQ(pilot_samples(8), 8u);
    EXPECT_EQ(pilot_samples(512), 32u);
    EXPECT_EQ(pilot_samples(1000000), 64u);
    EXPECT_NE(pilot_seed(0), 0u);
    EXPECT_NE(pilot_seed(7), 7u);
}
