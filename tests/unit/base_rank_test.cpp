// SPDX-License-Identifier: Apache-2.0
#include "base/rank_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/statistics.h"

using namespace lobe;

namespace {

// Share of p-values at or below a level.
double share_below(const std::vector<double>& p, double level) {
    const auto count = std::count_if(p.begin(), p.end(), [&](double v) { return v <= level; });
    return static_cast<double>(count) / static_cast<double>(p.size());
}

std::vector<double> normal_values(Random& random, int count, double mean = 0) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(mean + random.normal());
    return values;
}

// The test by its definition: all 2^n choices of signs.
double signed_rank_p_by_counting(const std::vector<double>& ranks, double positive) {
    const double all = [&] {
        double sum = 0;
        for (double r : ranks) sum += r;
        return sum;
    }();
    const double away = std::fabs(positive - 0.5 * all);
    const unsigned choices = 1u << ranks.size();
    unsigned as_far = 0;
    for (unsigned signs = 0; signs < choices; ++signs) {
        double sum = 0;
        for (std::size_t i = 0; i < ranks.size(); ++i)
            if (signs >> i & 1) sum += ranks[i];
        as_far += std::fabs(sum - 0.5 * all) >= away - 1e-9;
    }
    return static_cast<double>(as_far) / choices;
}

}  // namespace

// All of one sign: 2 / 2^n, the smallest p there is.
TEST(SignedRank, SmallestP) {
    EXPECT_DOUBLE_EQ(signed_rank_p({1}), 1);
    EXPECT_DOUBLE_EQ(signed_rank_p({1, 2, 3, 4, 5}), 2.0 / 32);
    EXPECT_DOUBLE_EQ(signed_rank_p({-1, -2, -3, -4, -5, -6}), 2.0 / 64);
    EXPECT_DOUBLE_EQ(signed_rank_p({}), 1);
    EXPECT_DOUBLE_EQ(signed_rank_p({0, 0}), 1);
    EXPECT_DOUBLE_EQ(signed_rank_p({0, 1, 2, 0, 3, 4, 5}), 2.0 / 32);
}

// n = 5 with rank 1 negative: sums 0 and 1 below, so 2 * 2 / 32.
TEST(SignedRank, HandCounted) {
    EXPECT_DOUBLE_EQ(signed_rank_p({-1, 2, 3, 4, 5}), 4.0 / 32);
    // Sums up to 3 of ranks 1..5: {}, {1}, {2}, {3}, {1, 2}.
    EXPECT_DOUBLE_EQ(signed_rank_p({1, 2, -3, 4, 5}), 10.0 / 32);
    EXPECT_DOUBLE_EQ(signed_rank_p({-1, -2, 3, 4, 5}), 10.0 / 32);
}

// Darwin's maize (Fisher, "The Design of Experiments", 1935, chapter 3): fifteen pairs in eighths
// of an inch, mean 20.93; t is 2.148 and p .0497; R's wilcox.test gives .0412 for the ranks.
TEST(SignedRank, DarwinsMaize) {
    const std::vector<double> maize = {49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};
    EXPECT_NEAR(signed_rank_p(maize), 0.04126, 1e-4);
    const MeanInterval mean = mean_interval(maize);
    EXPECT_NEAR(mean.mean, 20.933, 1e-3);
    EXPECT_NEAR(mean.p, 0.0497, 1e-4);
    EXPECT_NEAR(mean.lo, 0.03, 0.005);
    EXPECT_NEAR(mean.hi, 41.84, 0.005);
}

TEST(SignedRank, TiesShareTheirMeanRank) {
    // Sizes 1 1 2 3 3 3: ranks 1.5 1.5 3 5 5 5; positive 1.5 + 5 + 5.
    EXPECT_NEAR(signed_rank_p({1, -1, -2, 3, 3, -3}),
                signed_rank_p_by_counting({1.5, 1.5, 3, 5, 5, 5}, 11.5), 1e-12);
    EXPECT_NEAR(signed_rank_p({2, 2, 2, 2, 2, 2, -2}),
                signed_rank_p_by_counting({4, 4, 4, 4, 4, 4, 4}, 24), 1e-12);
}

TEST(SignedRank, DoesNotDependOnTheSign) {
    Random random(5);
    for (int count : {3, 20, 50, 51, 200}) {
        std::vector<double> values = normal_values(random, count, 0.2);
        const double p = signed_rank_p(values);
        for (double& value : values) value = -value;
        EXPECT_DOUBLE_EQ(signed_rank_p(values), p) << count;
    }
}

// The approximation against 20000 random choices of signs, with many ties.
TEST(SignedRank, TheApproximationIsGood) {
    Random random(6);
    for (double mean : {0.1, 0.2, 0.3}) {
        std::vector<double> sizes = normal_values(random, 70, mean);
        for (double& value : sizes) value = std::round(3 * value) / 3 + 1e-3;
        const double p = signed_rank_p(sizes);
        const int draws = 20000;
        int as_far = 0;
        for (int i = 0; i < draws; ++i) {
            std::vector<double> signs = sizes;
            for (double& value : signs)
                if (random.uniform() < 0.5) value = -value;
            as_far += signed_rank_p(signs) <= p * (1 + 1e-9);
        }
        EXPECT_NEAR(static_cast<double>(as_far) / draws, p,
                    4 * std::sqrt(p * (1 - p) / draws) + 0.02 * p);
    }
}

// p-values of nothing are uniform: at 3000 trials a share of .05 has a deviation of .004.
TEST(SignedRank, UniformUnderTheNull) {
    for (int count : {20, 80}) {
        Random random(7);
        std::vector<double> p;
        for (int trial = 0; trial < 3000; ++trial)
            p.push_back(signed_rank_p(normal_values(random, count)));
        for (double level : {0.05, 0.2, 0.5, 0.8})
            EXPECT_NEAR(share_below(p, level), level,
                        4 * std::sqrt(level * (1 - level) / 3000) + 0.003)
                << count;
    }
}

TEST(MeanInterval, UniformAndCoveringUnderTheNull) {
    Random random(8);
    std::vector<double> p;
    int covered = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const MeanInterval interval = mean_interval(normal_values(random, 20));
        p.push_back(interval.p);
        covered += interval.lo < 0 && 0 < interval.hi;
    }
    for (double level : {0.05, 0.2, 0.5, 0.8})
        EXPECT_NEAR(share_below(p, level), level, 4 * std::sqrt(level * (1 - level) / 3000));
    EXPECT_EQ(covered, 3000 - std::count_if(p.begin(), p.end(), [](double v) { return v < 0.05; }));
}

TEST(MeanInterval, Edges) {
    EXPECT_TRUE(std::isnan(mean_interval({}).mean));
    EXPECT_TRUE(std::isnan(mean_interval({1}).lo));
    EXPECT_TRUE(std::isnan(mean_interval({1}).p));
    const MeanInterval same = mean_interval({0, 0, 0});
    EXPECT_EQ(same.lo, 0);
    EXPECT_EQ(same.hi, 0);
    EXPECT_EQ(same.p, 1);
    EXPECT_EQ(mean_interval({2, 2, 2}).p, 0);
    const MeanInterval two = mean_interval({1, 3});
    EXPECT_NEAR(two.hi - two.mean, 12.706204736, 1e-6);
}

TEST(Holm, HandComputed) {
    // .01 * 3, .02 * 2, .04 * 1 not below the one before.
    EXPECT_EQ(holm({0.02, 0.01, 0.04}), (std::vector<double>{0.04, 0.03, 0.04}));
    EXPECT_EQ(holm({0.5}), (std::vector<double>{0.5}));
    EXPECT_EQ(holm({0.9, 0.8}), (std::vector<double>{1, 1}));
    EXPECT_TRUE(holm({}).empty());
    const std::vector<double> levels = holm_levels({0.02, 0.01, 0.04}, 0.06);
    EXPECT_DOUBLE_EQ(levels[0], 0.03);
    EXPECT_DOUBLE_EQ(levels[1], 0.02);
    EXPECT_DOUBLE_EQ(levels[2], 0.06);
}

// One or more false alarms among five nulls: at most 5 % of 4000 families (deviation .35 %).
TEST(Holm, KeepsTheFamilyLevel) {
    Random random(9);
    int families = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        std::vector<double> p;
        for (int i = 0; i < 5; ++i) p.push_back(random.uniform());
        const std::vector<double> adjusted = holm(p);
        families += *std::min_element(adjusted.begin(), adjusted.end()) < 0.05;
    }
    EXPECT_LT(families, 0.05 * 4000 + 4 * 13.8);
    EXPECT_GT(families, 0.05 * 4000 * 0.8);
}
