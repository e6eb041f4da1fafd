// SPDX-License-Identifier: Apache-2.0
// The instruments that other tests trust: each must see a fault and pass what is sound.
#include <gtest/gtest.h>

#include "support/chi_square.h"
#include "support/oracle.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Counts of 100 cells from a density 1 + slope (x - 1/2) on [0, 1), by rejection.
std::vector<double> histogram(std::uint64_t seed, double slope, int samples) {
    Random random(seed);
    std::vector<double> counts(100, 0);
    for (int taken = 0; taken < samples;) {
        const double x = random.uniform();
        if (random.uniform() * (1 + std::fabs(slope) / 2) > 1 + slope * (x - 0.5)) continue;
        ++counts[static_cast<std::size_t>(100 * x)];
        ++taken;
    }
    return counts;
}

}  // namespace

TEST(ChiSquare, PIsUniformForASoundSampler) {
    int below_tenth = 0;
    for (std::uint64_t seed = 0; seed < 500; ++seed)
        below_tenth += chi_square(histogram(seed, 0, 2000), std::vector<double>(100, 1)).p < 0.1;
    EXPECT_NEAR(below_tenth, 50, 4 * std::sqrt(500 * 0.1 * 0.9));
}

TEST(ChiSquare, SeesAWrongDensity) {
    const std::vector<double> flat(100, 1000);
    EXPECT_TRUE(follows(histogram(1, 0, 100000), flat, 200));
    EXPECT_FALSE(follows(histogram(1, 0.1, 100000), flat, 200));
}

TEST(ChiSquare, SeesLostSamplesOnlyUnscaled) {
    const std::vector<double> counts(100, 990), expected(100, 1000);
    EXPECT_NEAR(chi_square(counts, expected).statistic, 0, 1e-9);
    EXPECT_NEAR(chi_square(counts, expected, false).statistic, 10, 1e-9);
}

TEST(ChiSquare, PoolsSmallCellsAndRefusesTheImpossible) {
    const ChiSquare pooled = chi_square({3, 2, 1, 10, 10}, {2, 2, 2, 10, 10}, false);
    EXPECT_EQ(pooled.freedom, 3);  // three small cells became one
    EXPECT_NEAR(pooled.statistic, 0, 1e-12);
    EXPECT_EQ(chi_square({10, 1}, {11, 0}).p, 0);
    EXPECT_EQ(chi_square({10, 1}, {10, NAN}).p, 0);
    EXPECT_EQ(chi_square({}, {}).p, 0);
}

TEST(NormalDeviate, HasTheFamilysLevel) {
    EXPECT_TRUE(normal_deviate(4.5, 200));
    EXPECT_FALSE(normal_deviate(-4.6, 200));
    EXPECT_FALSE(normal_deviate(NAN, 200));
}

TEST(Oracle, Integrates) {
    EXPECT_LT(relative_error(integrate([](Long x) { return std::exp(x); }, 0, 1), std::expm1(1.0L)),
              1e-17);
    EXPECT_LT(relative_error(integrate([](Long x) { return 1 / std::sqrt(x); }, 0, 1), 2), 1e-9);
    EXPECT_LT(relative_error(integrate_hemisphere([](vec3l) { return 1.0L; }), 2 * pi), 1e-15);
    EXPECT_LT(relative_error(integrate_hemisphere([](vec3l w) { return w.z * w.x * w.x; }), pi / 4),
              1e-15);
}

TEST(Oracle, CountsUnitsInTheLastPlace) {
    EXPECT_EQ(ulp_error(1.0f, 1), 0);
    EXPECT_EQ(ulp_error(std::nextafter(1.0f, 2.0f), 1), 1);
    EXPECT_EQ(ulp_error(3.0f, 3 + std::ldexp(1.0L, -23)), 0.5);
    EXPECT_EQ(ulp_error(1e-45f, 0), 1);  // the smallest denormal
    EXPECT_EQ(ulp_error(INFINITY, 1e39L), 0);
    EXPECT_EQ(ulp_error(INFINITY, 1), INFINITY);
    EXPECT_EQ(ulp_error(NAN, 1), INFINITY);
}

TEST(Random, GivesTheSameNumbersEverywhere) {
    Random random(1234567);  // reference values of the authors' C code
    EXPECT_EQ(random.bits(), 6457827717110365317u);
    EXPECT_EQ(random.bits(), 3203168211198807973u);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_LT(random.below(7), 7u);
        EXPECT_LT(random.uniform_float(), 1.0f);
    }
}
