// SPDX-License-Identifier: Apache-2.0
#include "base/tail_index.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"

using namespace lobe;

namespace {

std::vector<double> pareto(double alpha, int count, Random& random) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(std::pow(1 - random.uniform(), -1 / alpha));
    return values;
}

}  // namespace

// Three values above 1, 2, 4 and 8 times as large: mean logarithm (1 + 2 + 3) ln 2 / 3.
TEST(TailIndex, ByHand) {
    const auto tail = tail_index({0.5, 8, 1, 2, -3, 4, NAN, 0.1}, 3);
    ASSERT_TRUE(tail);
    EXPECT_NEAR(tail->alpha, 1 / (2 * std::log(2)), 1e-14);
    EXPECT_NEAR(tail->error, tail->alpha / std::sqrt(3.0), 1e-14);
    EXPECT_EQ(tail->threshold, 1);
    EXPECT_EQ(tail->count, 3u);
    EXPECT_TRUE(tail->heavy());
}

TEST(TailIndex, FindsThePowerWithItsError) {
    Random random(1);
    for (const double alpha : {1.0, 1.5, 3.0}) {
        double sum = 0, squares = 0;
        constexpr int trials = 400;
        for (int i = 0; i < trials; ++i) {
            const auto tail = tail_index(pareto(alpha, 4096, random));
            ASSERT_TRUE(tail);
            EXPECT_NEAR(tail->error, tail->alpha / 8, 1e-12);
            sum += tail->alpha;
            squares += std::pow(tail->alpha - alpha, 2);
        }
        // The mean is alpha k / (k - 1), the deviation about alpha / sqrt(k) (5 % more at k = 64).
        EXPECT_NEAR(sum / trials / alpha, 64.0 / 63, 0.025);
        EXPECT_NEAR(std::sqrt(squares / trials) / (alpha / 8), 1, 0.15);
    }
}

TEST(TailIndex, LightTailsAreLight) {
    Random random(2);
    std::vector<double> values;
    for (int i = 0; i < 10000; ++i) values.push_back(std::fabs(random.normal()));
    EXPECT_GT(tail_index(values)->alpha, 4);
    EXPECT_FALSE(tail_index(values)->heavy());
    // A few fireflies in a thousand times as many are seen.
    for (const double spike : pareto(1.2, 100, random)) values.push_back(10 * spike);
    EXPECT_TRUE(tail_index(values)->heavy());
}

TEST(TailIndex, NothingToSee) {
    EXPECT_FALSE(tail_index({}));
    EXPECT_FALSE(tail_index({1, 2, 3}, 3));
    EXPECT_FALSE(tail_index(std::vector<double>(100, 2.0)));
    EXPECT_FALSE(tail_index({1, 2, 3}, 0));
    EXPECT_FALSE(tail_index({INFINITY, INFINITY, 1, 2}, 3));
}
