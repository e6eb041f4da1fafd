// SPDX-License-Identifier: Apache-2.0
// Lines through points whose line is known, and how far their stated errors can be trusted.
#include "base/regression.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "base/statistics.h"
#include "support/chi_square.h"

using namespace lobe;
using namespace lobe::test;

TEST(Regression, ExactPoints) {
    const LineFit fit = fit_line({1, 2, 4}, {5, 7, 11}, {1, 4, 9});
    EXPECT_NEAR(fit.slope, 2, 1e-14);
    EXPECT_NEAR(fit.intercept, 3, 1e-14);
    EXPECT_NEAR(fit.chi_square, 0, 1e-25);
    EXPECT_EQ(fit.freedom, 1);
    EXPECT_NEAR(fit.at(10), 23, 1e-13);
}

// By hand: equal variances 4 at x = -1, 0, 1 give slope (y3 - y1) / 2 with variance 4 / 2, height
// mean(y) with variance 4 / 3, and no covariance.
TEST(Regression, ErrorsByHand) {
    const LineFit fit = fit_line({-1, 0, 1}, {1, 0, 5}, {4, 4, 4});
    EXPECT_DOUBLE_EQ(fit.slope, 2);
    EXPECT_DOUBLE_EQ(fit.intercept, 2);
    EXPECT_DOUBLE_EQ(fit.slope_error, std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(fit.intercept_error, std::sqrt(4.0 / 3));
    EXPECT_DOUBLE_EQ(fit.covariance, 0);
    EXPECT_DOUBLE_EQ(fit.chi_square, (1 + 4 + 1) / 4.0);  // residuals 1, -2, 1
    EXPECT_DOUBLE_EQ(fit.p(), chi_square_survival(1.5, 1));
    EXPECT_DOUBLE_EQ(fit.error_at(1), std::sqrt(2 + 4.0 / 3));
    // Moved along x, the height at the same place keeps its error.
    const LineFit moved = fit_line({9, 10, 11}, {1, 0, 5}, {4, 4, 4});
    EXPECT_NEAR(moved.error_at(11), fit.error_at(1), 1e-12);
    EXPECT_NEAR(moved.error_at(10), fit.error_at(0), 1e-12);
}

// A point of twice the variance counts half: the same as two points of one place.
TEST(Regression, WeightsAreInverseVariances) {
    const LineFit two = fit_line({0, 0, 1, 3}, {1, 1, 2, 7}, {2, 2, 1, 3});
    const LineFit one = fit_line({0, 1, 3}, {1, 2, 7}, {1, 1, 3});
    EXPECT_NEAR(two.slope, one.slope, 1e-14);
    EXPECT_NEAR(two.intercept_error, one.intercept_error, 1e-14);
}

TEST(Regression, NoLine) {
    EXPECT_TRUE(std::isnan(fit_line({1}, {1}, {1}).slope));
    EXPECT_TRUE(std::isnan(fit_line({2, 2}, {1, 3}, {1, 1}).slope));
    EXPECT_TRUE(std::isnan(fit_line({1, 2}, {1, 3}, {1, 0}).slope));
    EXPECT_TRUE(std::isnan(fit_line({1, 2}, {1, 3}, {1, NAN}).slope));
    EXPECT_EQ(fit_line({1, 2}, {1, 3}, {1, 1}).p(), 1);
}

// Of the intervals of value +- 1.96 errors, 95 in 100 hold slope and intercept, for errors over
// three orders of magnitude, as those of MSE_k = v / N_k + b2 are; chi-square is where it should
// be.
TEST(Regression, IntervalsCover) {
    Random random(1);
    constexpr int trials = 4000;
    constexpr double v = 3, b2 = 0.004;
    int slopes = 0, intercepts = 0, products = 0, misfits = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> x, y, variance;
        for (int n = 4; n <= 512; n *= 2) {
            const double exact = v / n + b2, error = 0.05 * exact;
            x.push_back(1.0 / n);
            y.push_back(exact + error * random.normal());
            variance.push_back(error * error);
        }
        const LineFit fit = fit_line(x, y, variance);
        slopes += std::fabs(fit.slope - v) < 1.96 * fit.slope_error;
        intercepts += std::fabs(fit.intercept - b2) < 1.96 * fit.intercept_error;
        products += (fit.slope - v) * (fit.intercept - b2) < 0;
        misfits += fit.p() < 0.05;
        ASSERT_EQ(fit.freedom, 6);
        ASSERT_LT(fit.covariance, 0);
    }
    const auto rate = [&](int found, double expected) {
        return normal_deviate(
            (found - expected * trials) / std::sqrt(expected * (1 - expected) * trials), 4);
    };
    EXPECT_TRUE(rate(slopes, 0.95)) << slopes;
    EXPECT_TRUE(rate(intercepts, 0.95)) << intercepts;
    EXPECT_TRUE(rate(misfits, 0.05)) << misfits;
    EXPECT_GT(products, trials / 2);  // correlated as said
}

// The log-log slope of errors of eight doublings, and its stated error.
TEST(Regression, LogLogSlopes) {
    Random random(2);
    constexpr int trials = 2000;
    int held = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> x, y, variance;
        for (int n = 4; n <= 512; n *= 2) {
            x.push_back(std::log(n));
            y.push_back(0.5 * std::log(2.0 / n * (1 + 0.02 * random.normal())));
            variance.push_back(0.25 * 0.02 * 0.02);
        }
        const LineFit fit = fit_line(x, y, variance);
        ASSERT_NEAR(fit.slope, -0.5, 0.02);
        held += std::fabs(fit.slope + 0.5) < 1.96 * fit.slope_error;
    }
    EXPECT_TRUE(normal_deviate((held - 0.95 * trials) / std::sqrt(0.95 * 0.05 * trials), 1))
        << held;
}

TEST(Regression, TheilSenShrugsAtOutliers) {
    EXPECT_DOUBLE_EQ(theil_sen_slope({1, 2, 3}, {2, 4, 6}), 2);
    EXPECT_DOUBLE_EQ(theil_sen_slope({1, 1, 2}, {0, 10, 7}), 2);  // slopes 7 and -3; no 1-1 pair
    EXPECT_TRUE(std::isnan(theil_sen_slope({1, 1}, {0, 10})));
    std::vector<double> x, y;
    for (int i = 0; i < 16; ++i) {
        x.push_back(i);
        y.push_back(0.25 * i + 3 + (i % 4 == 1 ? 1000 : 0));  // a quarter of them anywhere
    }
    EXPECT_NEAR(theil_sen_slope(x, y), 0.25, 1e-12);
    EXPECT_NEAR(theil_sen_intercept(x, y, 0.25), 3, 1e-12);
}
