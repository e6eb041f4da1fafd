// SPDX-License-Identifier: Apache-2.0
// What float makes of the formulas as they are printed, beside lobe's own: the rational lobe at a
// given cosine, its normalisation, points of lobes by inversion, and the corners where the printed
// formulas break. Relative errors against long double; the published figures, of other samples of
// inputs, stand beside ours. What the printed formulas do wrong is a test as well: it is why
// they are not used.
#include <gtest/gtest.h>

#include "base/random.h"
#include "base/statistics.h"
#include "kernel/brdf_probe.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class BrdfNumbersFloat : public testing::Test {
  protected:
    std::vector<float> call(const char* kernel, std::size_t width, const std::vector<float>& a) {
        Buffer<float> out(test_device(), a.size() * width);
        run_probe(program_, kernel, a.size(), Buffer<float>(test_device(), a), out);
        return out.read_all();
    }
    std::vector<float> call(const char* kernel, std::size_t width, const std::vector<float>& a,
                            const std::vector<float>& b) {
        Buffer<float> out(test_device(), a.size() * width);
        run_probe(program_, kernel, a.size(), Buffer<float>(test_device(), a),
                  Buffer<float>(test_device(), b), out);
        return out.read_all();
    }
    Program program_ = build_probe("probe/brdf_naive.cl");
};

constexpr float one_minus = 1 - 0x1p-24f, one_plus = 1 + 0x1p-23f;
constexpr std::size_t count = 100000;

// The largest relative error of every `width`-th value from `column` on; NaN and infinity apart.
struct Column {
    double worst = 0, median = 0, nonfinite = 0;  // the last as a share
};
Column column_of(const std::vector<float>& out, std::size_t width, std::size_t column,
                 const std::vector<Long>& exact) {
    Column result;
    std::vector<double> errors;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const float value = out[width * i + column];
        if (std::isfinite(value))
            errors.push_back(relative_error(value, exact[i]));
        else
            result.nonfinite += 1.0 / static_cast<double>(exact.size());
    }
    result.median = median(errors);
    for (const double error : errors) result.worst = std::max(result.worst, error);
    return result;
}

// J and K by their series about n = 1, and by the closed forms elsewhere.
Long moment(Long n, int power) {
    const Long a = n - 1;
    if (std::fabs(a) < 0.3L) {
        Long sum = 0, term = 1;
        for (int k = 0; k < 60; ++k, term *= -a)
            sum += power == 0 ? term / ((k + 1) * (k + 2))
                              : 2 * term / Long((k + 1) * (k + 2) * (k + 3));
        return sum;
    }
    const Long j = (n * std::log(n) - a) / (a * a);
    return power == 0 ? j : (n * j - 0.5L) / a;
}

}  // namespace

// g at a cosine that is given exactly: c / (n - (n-1) c), with one rounding fewer, lobe's.
TEST_F(BrdfNumbersFloat, LobeOfAGivenCosine) {
    struct {
        double n, printed, fused;  // published
    } const rows[] = {{10, 5.0e-7, 1.0e-7},  {1e3, 3.0e-5, 9.5e-8}, {1e5, 3.7e-3, 1.1e-7},
                      {1e6, 1.9e-2, 9.5e-8}, {1e7, .20, 1.0e-7},    {1e8, .62, .17}};
    std::printf("       n: printed (published), fused (published), lobe's (1.3e-7)\n");
    for (const auto& row : rows) {
        Random random(61);
        std::vector<float> n(count, static_cast<float>(row.n)), c;
        std::vector<Long> exact;
        for (std::size_t i = 0; i < count; ++i) {
            c.push_back(static_cast<float>(1 - random.log_uniform(1e-8, 1)));
            exact.push_back(c[i] / (c[i] + n[i] * (1 - Long(c[i]))));
        }
        const auto out = call("naive_rational", 3, n, c);
        const Column printed = column_of(out, 3, 0, exact), fused = column_of(out, 3, 1, exact);
        const Column ours = column_of(out, 3, 2, exact);
        std::printf("  %6g: %.1e (%.1e) %4.1f %% inf, %.1e (%.1e), %.1e\n", row.n, printed.worst,
                    row.printed, 100 * printed.nonfinite, fused.worst, row.fused, ours.worst);
        EXPECT_LE(ours.worst, 2.5e-7) << row.n;
        EXPECT_EQ(ours.nonfinite, 0) << row.n;
        EXPECT_GT(printed.worst, row.printed / 3) << row.n;
        EXPECT_LT(printed.worst, row.printed * 3) << row.n;
        EXPECT_LT(fused.worst, row.fused * 3) << row.n;
        // From 2^25 on n - 1 is n, and the printed denominator is 0 at c = 1.
        EXPECT_EQ(printed.nonfinite > 0, row.n > 0x1p25) << row.n;
    }
}

// ln n / (n - 1), J and K about n = 1, where the printed forms cancel, and where they overflow.
TEST_F(BrdfNumbersFloat, Normalisers) {
    struct {
        double low, high;  // of n - 1
        double j, k;       // published worst errors
    } const rows[] = {{-1e-1, -1e-2, 1.8e-5, .41}, {-1e-2, -1e-4, 1.3e-3, 3.5e5},
                      {-1e-4, -1e-6, .12, 3e11},   {1e-2, 1e-1, 1.8e-5, .41},
                      {1e-4, 1e-2, 1.3e-3, 3.5e5}, {1e-6, 1e-4, 7e-2, 3e11}};
    std::printf("  n - 1 in: J printed (published), K printed (published)\n");
    for (const auto& row : rows) {
        Random random(62);
        std::vector<float> n;
        std::vector<Long> j, k, log_over;
        for (std::size_t i = 0; i < count; ++i) {
            n.push_back(static_cast<float>(1 + random.log_uniform(row.low, row.high)));
            j.push_back(moment(n[i], 0));
            k.push_back(moment(n[i], 1));
            log_over.push_back(std::log1p(n[i] - 1.0L) / (n[i] - 1.0L));
        }
        const auto out = call("naive_moments", 3, n);
        const Column l = column_of(out, 3, 0, log_over);
        const Column of_j = column_of(out, 3, 1, j), of_k = column_of(out, 3, 2, k);
        std::printf("  %6g, %6g: %.1e (%.1e), %.1e (%.1e)\n", row.low, row.high, of_j.worst, row.j,
                    of_k.worst, row.k);
        EXPECT_LE(l.worst, 1.7e-7);
        EXPECT_NEAR(of_j.worst / row.j, 1, 0.2);
        EXPECT_NEAR(of_k.worst / row.k, 1, 0.3);
    }
    const auto ends = call("naive_moments", 3, {1, 1e20f, 1e13f});
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isnan(ends[k])) << k;
    EXPECT_EQ(ends[4], 0);                             // a^2 overflows: J is all wrong
    EXPECT_TRUE(std::isnan(ends[8]) || ends[8] == 0);  // and K from 1e12 on
}

namespace {

// Errors of naive_points for numbers u of one n.
struct PointErrors {
    Column x, t, good_x, good_t, sine, good_sine;
};

}  // namespace

// x = 1 - t of the density 1 / (n - (n-1) t), and the sine of an angle of the density t^n.
TEST_F(BrdfNumbersFloat, PointsOfLobes) {
    const auto errors = [&](double value, const std::vector<float>& u) {
        const std::vector<float> n(u.size(), static_cast<float>(value));
        std::vector<Long> x, t, sine;
        for (std::size_t i = 0; i < u.size(); ++i) {
            const Long a = Long(n[i]) - 1, l = std::log(Long(n[i]));
            x.push_back(std::expm1(u[i] * l) / a);
            t.push_back(-n[i] * std::expm1((u[i] - 1.0L) * l) / a);
            const Long px = -std::expm1(std::log1p(-Long(u[i])) / (Long(n[i]) + 1));
            sine.push_back(std::sqrt(px * (2 - px)));
        }
        const auto out = call("naive_points", 6, n, u);
        return PointErrors{column_of(out, 6, 0, x),    column_of(out, 6, 1, t),
                           column_of(out, 6, 2, x),    column_of(out, 6, 3, t),
                           column_of(out, 6, 4, sine), column_of(out, 6, 5, sine)};
    };
    struct {
        double n, median_x, median_sine;  // published, of the printed formulas; 0: none
    } const rows[] = {
        {10, 0, 0},    {1e2, 0, 8.7e-7},   {1e4, 1.8e-6, 9.8e-5}, {1e6, 1.1e-5, 9.5e-3},
        {1e7, 0, .10}, {1e8, 1.7e-4, 1.0}, {1e10, 1e-3, 1.0}};
    Random random(63);
    std::vector<float> even, ends;
    for (std::size_t i = 0; i < count; ++i) {
        even.push_back(std::max(random.uniform_float(), 0x1p-24f));
        const auto u = static_cast<float>(std::floor(random.log_uniform(1, 0x1p24 - 1)) * 0x1p-24);
        ends.push_back(i % 2 ? std::min(u, one_minus) : std::max(1 - u, 0x1p-24f));
    }
    std::printf(
        "      n: x printed worst, median (published), t worst; expm1 x, t; sine printed "
        "median (published), lobe's worst\n");
    for (const auto& row : rows) {
        const PointErrors middle = errors(row.n, even), end = errors(row.n, ends);
        std::printf("  %5g: %.1e %.1e (%.1e) %.1e; %.1e %.1e; %.1e (%.1e) %.1e\n", row.n,
                    end.x.worst, middle.x.median, row.median_x, end.t.worst, end.good_x.worst,
                    end.good_t.worst, middle.sine.median, row.median_sine, end.good_sine.worst);
        EXPECT_GE(end.x.worst, 1) << row.n;  // the peak collapses onto one point
        EXPECT_LE(end.good_x.worst, 2e-6) << row.n;
        EXPECT_LE(end.good_t.worst, 6e-7) << row.n;
        EXPECT_LE(end.good_sine.worst, 3e-7) << row.n;
        if (row.n == 10) {
            EXPECT_NEAR(end.t.worst, .35, .06);
        }
        if (row.median_x > 0) {
            EXPECT_NEAR(std::log2(middle.x.median / row.median_x), 0, 1) << row.n;
        }
        if (row.median_sine > 0) {
            EXPECT_NEAR(std::log2(middle.sine.median / row.median_sine), 0, .3) << row.n;
        }
    }
    EXPECT_NEAR(errors(1, even).x.nonfinite, 1, 1e-6);  // NaN at n = 1
    EXPECT_NEAR(errors(1 + 1e-6, even).x.median, .045, .02);
    EXPECT_LE(errors(1e30, ends).good_x.worst, 5e-6);
}

// t of the proxy at the ends and in the middle: x = 1 / (1 + sqrt n) at u = 1/2.
TEST_F(BrdfNumbersFloat, ProxyAtItsEnds) {
    for (const float n : {10.0f, 1e4f, 1e8f, 1e12f}) {
        const auto out = call("naive_points", 6, {n, n, n}, {0, 0.5f, 1});
        EXPECT_EQ(out[2], 0) << n;
        EXPECT_NEAR(out[6 + 2] * (1 + std::sqrt(n)), 1, 2e-6) << n;
        EXPECT_EQ(out[12 + 3], 0) << n;
    }
}

// Where the printed formulas break, and what lobe gives there.
TEST_F(BrdfNumbersFloat, Corners) {
    const float inf = INFINITY;
    const auto out = call("naive_rational", 3, {0, inf, 1e8f, 1e8f}, {0, 0.5f, 1, one_plus});
    EXPECT_TRUE(std::isnan(out[0]));  // n = 0, c = 0
    EXPECT_EQ(out[2], 0);
    EXPECT_TRUE(std::isnan(out[3]));  // n infinite
    EXPECT_EQ(out[6], inf);           // n = 1e8, c = 1: inf
    EXPECT_EQ(out[8], 1);
    EXPECT_NEAR(out[9], -0.125, 1e-6);  // n = 1e8, c = 1 + 1 ulp: negative light
    // c below 0: negative, -1 / (2 n - 1) at the worst, and below n = 1/2 a pole.
    const auto below = call("naive_rational", 3, {20, 0.25f}, {-1, -1.0f / 3});
    EXPECT_NEAR(below[0], -1.0 / 39, 1e-8);
    EXPECT_TRUE(std::fabs(below[3]) > 1e6 || std::isinf(below[3]));
    for (const int i : {2, 5}) EXPECT_EQ(below[i], 0);
}
