// SPDX-License-Identifier: Apache-2.0
// The elementary functions of core/math.h in units of the last place against long double.
#include <gtest/gtest.h>

#include <cstring>

#include "support/oracle.h"
#include "support/probe.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr float inf = INFINITY;

std::vector<float> spread(double low, double high, int count = 1 << 17) {
    Random random(1);
    std::vector<float> values = {float(low), float(high)};
    for (int i = 0; i < count; ++i) values.push_back(float(random.uniform(low, high)));
    return values;
}

std::vector<float> log_spread(double low, double high, double sign = 1, int count = 1 << 17) {
    Random random(2);
    std::vector<float> values;
    for (int i = 0; i < count; ++i) values.push_back(float(sign * random.log_uniform(low, high)));
    return values;
}

Long exact_exp(Long x) { return std::exp(x); }
Long exact_expm1(Long x) { return std::expm1(x); }
Long exact_log(Long x) { return std::log(x); }
Long exact_log1p(Long x) { return std::log1p(x); }

class Math : public testing::Test {
  protected:
    std::vector<float> call(const char* kernel, const std::vector<float>& a, int width = 1) {
        Buffer<float> out(test_device(), a.size() * width);
        run_probe(program_, kernel, a.size(), Buffer<float>(test_device(), a), out);
        return out.read_all();
    }
    std::vector<float> call2(const char* kernel, const std::vector<float>& a,
                             const std::vector<float>& b) {
        Buffer<float> out(test_device(), a.size());
        run_probe(program_, kernel, a.size(), Buffer<float>(test_device(), a),
                  Buffer<float>(test_device(), b), out);
        return out.read_all();
    }

    // The largest error of a function over arguments, in ulp; also printed.
    double worst_ulp(const char* kernel, const std::vector<float>& arguments, Long (*exact)(Long)) {
        const std::vector<float> values = call(kernel, arguments);
        double worst = 0;
        std::size_t at = 0;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const double error = ulp_error(values[i], exact(arguments[i]));
            if (!(error <= worst)) worst = error, at = i;
        }
        const auto ends = std::minmax_element(arguments.begin(), arguments.end());
        std::printf("  %-12s [%g, %g]: %.3f ulp at %.9g\n", kernel, double(*ends.first),
                    double(*ends.second), worst, double(arguments[at]));
        return worst;
    }

  private:
    Program program_ = build_probe("probe/math.cl");
};

}  // namespace

TEST_F(Math, ExpWithinTwoUlp) {
    EXPECT_LE(worst_ulp("math_exp", spread(-87, 88.7), exact_exp), 1.5);
    EXPECT_LE(worst_ulp("math_exp", spread(-1, 1), exact_exp), 1.5);
    EXPECT_LE(worst_ulp("math_exp", log_spread(1e-38, 1), exact_exp), 1.5);
}

TEST_F(Math, Expm1KeepsSmallArguments) {
    EXPECT_LE(worst_ulp("math_expm1", spread(-20, 88.7), exact_expm1), 2);
    EXPECT_LE(worst_ulp("math_expm1", spread(-1, 1), exact_expm1), 2);
    EXPECT_LE(worst_ulp("math_expm1", log_spread(1e-38, 1), exact_expm1), 2);
    EXPECT_LE(worst_ulp("math_expm1", log_spread(1e-38, 1, -1), exact_expm1), 2);
}

TEST_F(Math, LogWithinTwoUlp) {
    EXPECT_LE(worst_ulp("math_log", log_spread(1e-38, 3e38), exact_log), 1.5);
    EXPECT_LE(worst_ulp("math_log", spread(0.5, 2), exact_log), 1.5);
    EXPECT_LE(worst_ulp("math_log", spread(0.99, 1.01), exact_log), 1.5);
}

TEST_F(Math, Log1pKeepsSmallArguments) {
    EXPECT_LE(worst_ulp("math_log1p", spread(-0.9999999, 1), exact_log1p), 2);
    EXPECT_LE(worst_ulp("math_log1p", log_spread(1e-38, 3e38), exact_log1p), 2);
    EXPECT_LE(worst_ulp("math_log1p", log_spread(1e-38, 0.999, -1), exact_log1p), 2);
}

// Of t = 1 - x, each given to its own precision.
TEST_F(Math, LogSplitKeepsBothEnds) {
    std::vector<float> t, x;
    std::vector<Long> exact;
    Random random(7);
    for (int i = 0; i < 1 << 17; ++i) {
        const float small = float(random.log_uniform(1e-37, 0.5));
        t.push_back(i % 2 ? small : 1 - small);
        x.push_back(i % 2 ? 1 - small : small);
        exact.push_back(i % 2 ? std::log(Long(small)) : std::log1p(-Long(small)));
    }
    const std::vector<float> y = call2("math_log_split", t, x);
    double worst = 0;
    for (std::size_t i = 0; i < t.size(); ++i) worst = std::max(worst, ulp_error(y[i], exact[i]));
    std::printf("  log_split: %.3f ulp\n", worst);
    EXPECT_LE(worst, 2);
    EXPECT_EQ(call2("math_log_split", {1}, {0})[0], 0);
}

// Relative to the nearest axis: the sine of a small angle counts its own ulps.
TEST_F(Math, CircleWithinTwoUlp) {
    for (const char* kernel : {"math_circle", "math_circle_octant"}) {
        std::vector<float> turns = spread(-0.125, 0.125);
        if (!std::strcmp(kernel, "math_circle"))
            for (float u : spread(-3, 3)) turns.push_back(u);
        for (float u : log_spread(1e-30, 0.1)) turns.push_back(u);
        const std::vector<float> out = call(kernel, turns, 2);
        double cosine = 0, sine = 0;
        for (std::size_t i = 0; i < turns.size(); ++i) {
            // Reduce exactly first: long double's 2 pi u would not be exact enough near an axis.
            const Long quarter = std::nearbyint(4 * Long(turns[i]));
            const Long angle = 2 * pi * (Long(turns[i]) - quarter / 4);
            Long c = std::cos(angle), s = std::sin(angle);
            for (int k = 0; k < (int(quarter) & 3); ++k) std::swap(c, s), c = -c;
            cosine = std::max(cosine, ulp_error(out[2 * i], c));
            sine = std::max(sine, ulp_error(out[2 * i + 1], s));
        }
        std::printf("  %s: cosine %.3f, sine %.3f ulp\n", kernel, cosine, sine);
        EXPECT_LE(cosine, 2) << kernel;
        EXPECT_LE(sine, 2) << kernel;
    }
}

TEST_F(Math, AngleInvertsCircle) {
    const std::vector<float> y = log_spread(1e-6, 1);
    std::vector<float> x = spread(0, 1);
    x.resize(y.size());
    const std::vector<float> a = call2("math_angle", y, x);
    double worst = 0;
    for (std::size_t i = 0; i < y.size(); ++i)
        worst = std::max(worst, ulp_error(a[i], std::atan2(Long(y[i]), Long(x[i])) / (2 * pi)));
    std::printf("  angle: %.3f ulp\n", worst);
    EXPECT_LE(worst, 3);
    EXPECT_EQ(call2("math_angle", {0, 1, 1, 1e-30f}, {1, 0, 1, 1e30f}),
              (std::vector<float>{0, 0.25f, 0.125f, 0}));
}

TEST_F(Math, PowerErrsWithItsLogarithm) {
    Random random(3);
    std::vector<float> base, n;
    for (int i = 0; i < 1 << 17; ++i) {
        base.push_back(float(random.uniform()));
        n.push_back(float(random.log_uniform(1e-3, 1e4)));
    }
    const std::vector<float> p = call2("math_power", base, n);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Long exponent = Long(n[i]) * std::log(Long(base[i]));
        if (base[i] == 0 || exponent < -87) continue;
        ASSERT_LE(relative_error(p[i], std::exp(exponent)),
                  6e-8 * (2 + 3 * std::fabs(double(exponent))))
            << base[i] << "^" << n[i];
    }
    EXPECT_EQ(call2("math_power", {0, 0, 1, 0.5f}, {0, 2, 1e30f, 1}),
              (std::vector<float>{1, 0, 1, 0.5f}));
}

TEST_F(Math, Limits) {
    const float nan = NAN;
    EXPECT_EQ(call("math_exp", {0, -inf, inf, -1e30f, 1e30f, 88.8f, -104}),
              (std::vector<float>{1, 0, inf, 0, inf, inf, 0}));
    EXPECT_EQ(call("math_expm1", {0, -inf, inf, -30, 89}),
              (std::vector<float>{0, -1, inf, -1, inf}));
    EXPECT_EQ(call("math_log", {1, 0, inf}), (std::vector<float>{0, -inf, inf}));
    EXPECT_EQ(call("math_log1p", {0, -1, inf}), (std::vector<float>{0, -inf, inf}));
    for (const char* kernel : {"math_exp", "math_expm1", "math_log", "math_log1p"})
        EXPECT_TRUE(std::isnan(call(kernel, {nan})[0])) << kernel;
    EXPECT_TRUE(std::isnan(call("math_log", {-1})[0]));
    EXPECT_TRUE(std::isnan(call("math_log1p", {-1.5f})[0]));
}

// Densities whose squares overflow, or that are both 0 (E. Veach's weights as a ratio).
TEST_F(Math, PowerHeuristicExtremesGiveAWeight) {
    EXPECT_EQ(call2("math_power_heuristic", {1, 0, 0, 1, 1e30f, 1e-30f, 3e38f, 1e-38f, 1e30f},
                    {1, 0, 1, 0, 1e30f, 1e30f, 1e-38f, 3e38f, 0}),
              (std::vector<float>{0.5f, 0, 0, 1, 0.5f, 0, 1, 0, 1}));
    const float w = call2("math_power_heuristic", {3e20f}, {1e20f})[0];
    EXPECT_NEAR(w, 0.9, 1e-6);
}

TEST_F(Math, BalanceHeuristicExtremesGiveAWeight) {
    EXPECT_EQ(call2("math_balance_heuristic", {1, 0, 0, 1, 3e38f, 1e-30f, 3e38f, 1e-38f, 1e30f},
                    {1, 0, 1, 0, 3e38f, 1e30f, 1e-38f, 3e38f, 0}),
              (std::vector<float>{0.5f, 0, 0, 1, 0.5f, 0, 1, 0, 1}));
    EXPECT_NEAR(call2("math_balance_heuristic", {3e38f}, {1e38f})[0], 0.75, 1e-6);
}
