// SPDX-License-Identifier: Apache-2.0
// Stopping at a stated error, on films whose variance is known.
#include "report/error_target.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "support/film_blocks.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr std::uint32_t side = 112;
constexpr double level = 1, deviation = 0.5;  // of a sample

// Grey noise of a uniform distribution.
std::vector<LobeBlockSum> noise(Random& random) {
    std::vector<LobeBlockSum> sums(std::size_t{side} * side * LOBE_REPLICATES);
    for (LobeBlockSum& sum : sums)
        for (int s = 0; s < LOBE_BLOCK / LOBE_REPLICATES; ++s) {
            const auto v = float(level + deviation * std::sqrt(12.0) * (random.uniform() - 0.5));
            sum.r += v, sum.g += v, sum.b += v;
        }
    return sums;
}

struct Outcome {
    double samples;
    unsigned looks;
    bool reached;
};

Outcome grow(double target, Random& random, std::uint32_t most = 100000) {
    ErrorTarget rule(target);
    Film film(side, side);
    while (!rule.met(film) && film.samples() < most) add_block(film, noise(random), LOBE_BLOCK);
    return {film.mean_samples(), rule.looks(), rule.reached()};
}

double exact_error(double samples) { return deviation / level / std::sqrt(samples); }

}  // namespace

// The error at the stop is below the target in 95 of 100 renders at least, and not far below.
TEST(ErrorTarget, StopsJustBelowTheTarget) {
    Random random(1);
    constexpr int trials = 40;
    int missed = 0;
    for (int i = 0; i < trials; ++i) {
        const Outcome outcome = grow(0.05, random);  // 100 samples
        ASSERT_TRUE(outcome.reached);
        missed += exact_error(outcome.samples) > 0.05;
        EXPECT_GT(exact_error(outcome.samples), 0.05 * 0.9) << outcome.samples << " samples";
        EXPECT_LT(outcome.looks, 12u);
    }
    EXPECT_LE(missed, 6);  // of 40 at most 2 expected
}

TEST(ErrorTarget, IsQuickWhereLittleIsAsked) {
    Random random(2);
    const Outcome outcome = grow(0.5, random);
    EXPECT_TRUE(outcome.reached);
    EXPECT_EQ(outcome.samples, 2 * LOBE_BLOCK) << "one look to scout, one to decide";
    EXPECT_EQ(outcome.looks, 2u);
}

TEST(ErrorTarget, PredictsWhatItNeeds) {
    Random random(3);
    ErrorTarget rule(0.01);  // 2500 samples
    Film film(side, side);
    EXPECT_EQ(rule.samples_needed(), 0);
    EXPECT_FALSE(rule.met(film));
    EXPECT_EQ(rule.looks(), 0u);
    for (int i = 0; i < 10; ++i) add_block(film, noise(random), LOBE_BLOCK);
    EXPECT_FALSE(rule.met(film));
    EXPECT_NEAR(rule.samples_needed() / 2500, 1, 0.2);
    EXPECT_GT(rule.bound(), exact_error(80));
    EXPECT_FALSE(rule.met(film));
    EXPECT_EQ(rule.looks(), 1u) << "it is not time for another";
    EXPECT_FALSE(rule.met_at_last(film));
    EXPECT_EQ(rule.looks(), 2u);
}

// A black picture says nothing of its error.
TEST(ErrorTarget, BlackIsNeverEnough) {
    ErrorTarget rule(0.5);
    Film film(side, side);
    for (int i = 0; i < 20; ++i) {
        add_block(film, std::vector<LobeBlockSum>(film.pixels() * LOBE_REPLICATES), LOBE_BLOCK);
        EXPECT_FALSE(rule.met(film));
    }
    EXPECT_EQ(rule.samples_needed(), 0);
    EXPECT_LT(rule.looks(), 20u);
}
