// SPDX-License-Identifier: Apache-2.0
// Reference values: closed forms, and tables (Abramowitz and Stegun 26; R's qt, qnorm, pchisq).
#include "base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace lobe;

namespace {
void expect_relative(double value, double exact, double tolerance) {
    EXPECT_NEAR(value, exact, std::fabs(exact) * tolerance);
}
const double pi = std::acos(-1.0);
}  // namespace

TEST(Statistics, Moments) {
    EXPECT_EQ(mean({1, 2, 3, 6}), 3);
    EXPECT_DOUBLE_EQ(sample_variance({1, 2, 3, 6}), 14.0 / 3);
    EXPECT_DOUBLE_EQ(standard_error({1, 2, 3, 6}), std::sqrt(14.0 / 12));
    EXPECT_EQ(median({5, 1, 3}), 3);
    EXPECT_EQ(median({5, 1, 3, 4}), 3.5);
    EXPECT_TRUE(std::isnan(mean({})));
    EXPECT_TRUE(std::isnan(sample_variance({1})));
    EXPECT_DOUBLE_EQ(sample_variance({1e9 + 1, 1e9 + 2, 1e9 + 3}), 1);
}

TEST(Statistics, Normal) {
    EXPECT_DOUBLE_EQ(normal_cdf(0), 0.5);
    expect_relative(normal_cdf(-10), 7.619853024160527e-24, 1e-13);
    expect_relative(normal_quantile(0.975), 1.959963984540054, 1e-14);
    expect_relative(normal_quantile(1e-10), -6.361340902404056, 1e-13);
    expect_relative(normal_quantile(0.999), 3.090232306167813, 1e-13);
    EXPECT_EQ(normal_quantile(0.5), 0);
    EXPECT_EQ(normal_quantile(0), -INFINITY);
    EXPECT_EQ(normal_quantile(1), INFINITY);
    EXPECT_TRUE(std::isnan(normal_quantile(1.5)));
    expect_relative(two_sided_p(1.959963984540054), 0.05, 1e-13);
    expect_relative(two_sided_p(-4.56), 5.115e-6, 1e-3);
}

TEST(Statistics, StudentHasClosedFormsForOneAndTwo) {
    for (const double t : {-1e6, -30.0, -2.0, -0.1, 0.0, 0.3, 5.0}) {
        expect_relative(student_cdf(t, 1), std::atan2(1, -t) / pi, 1e-12);
        const double root = std::sqrt(2 + t * t);  // (1 + t / root) / 2 without cancellation
        const double tail = 1 / (root * (root + std::fabs(t)));
        expect_relative(student_cdf(t, 2), t < 0 ? tail : 1 - tail, 1e-12);
    }
}

TEST(Statistics, StudentQuantiles) {
    expect_relative(student_quantile(0.975, 1), 12.706204736174698, 1e-12);
    expect_relative(student_quantile(0.975, 2), 4.302652729749464, 1e-12);
    expect_relative(student_quantile(0.975, 3), 3.182446305284263, 1e-12);
    expect_relative(student_quantile(0.975, 10), 2.2281388519862747, 1e-12);
    expect_relative(student_quantile(0.995, 30), 2.749995653567231, 1e-12);
    expect_relative(student_quantile(0.025, 3), -3.182446305284263, 1e-12);
    expect_relative(student_quantile(0.975, 490000), 1.9599688, 1e-6);
    expect_relative(student_quantile(0.975, INFINITY), 1.959963984540054, 1e-12);
    for (const double freedom : {1.0, 2.5, 7.0, 100.0, 1e5})
        for (const double p : {1e-9, 0.01, 0.3, 0.9})
            expect_relative(student_cdf(student_quantile(p, freedom), freedom), p, 1e-9);
}

TEST(Statistics, ChiSquareHasClosedFormsForOneTwoFour) {
    for (const double x : {1e-3, 0.5, 1.0, 3.0, 10.0, 60.0, 300.0}) {
        expect_relative(chi_square_survival(x, 1), std::erfc(std::sqrt(x / 2)), 1e-11);
        expect_relative(chi_square_survival(x, 2), std::exp(-x / 2), 1e-12);
        expect_relative(chi_square_survival(x, 4), std::exp(-x / 2) * (1 + x / 2), 1e-12);
    }
    EXPECT_EQ(chi_square_survival(0, 3), 1);
    EXPECT_EQ(chi_square_survival(INFINITY, 3), 0);
    expect_relative(chi_square_survival(124.342, 100), 0.05, 1e-4);
    expect_relative(chi_square_survival(1e6, 1e6), 0.4998, 1e-3);
}

TEST(Statistics, SidakKeepsTheFamilyLevel) {
    expect_relative(sidak(1e-3, 200), 5.0025e-6, 1e-4);
    expect_relative(1 - std::pow(1 - sidak(0.05, 7), 7), 0.05, 1e-12);
    EXPECT_DOUBLE_EQ(sidak(0.01, 1), 0.01);
}
