// SPDX-License-Identifier: Apache-2.0
// The lobes' own functions against long double: values, integrals, inverses, geometry.
#include <gtest/gtest.h>

#include "kernel/brdf_probe.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr float one_minus = 1 - 0x1p-24f, one_plus = 1 + 0x1p-23f;

class BrdfLobe : public testing::Test {
  protected:
    std::vector<float> call(const char* kernel, const std::vector<float>& a,
                            const std::vector<float>& b, int width) {
        Buffer<float> out(test_device(), a.size() * width);
        run_probe(program_, kernel, a.size(), Buffer<float>(test_device(), a),
                  Buffer<float>(test_device(), b), out);
        return out.read_all();
    }
    std::vector<float> values(const std::vector<float>& n, const std::vector<float>& x,
                              const std::vector<float>& t) {
        Buffer<float> out(test_device(), 2 * n.size());
        run_probe(program_, "lobe_values", n.size(), Buffer<float>(test_device(), n),
                  Buffer<float>(test_device(), x), Buffer<float>(test_device(), t), out);
        return out.read_all();
    }
    std::vector<float> moments(const std::vector<float>& n) {
        Buffer<float> out(test_device(), 2 * n.size());
        run_probe(program_, "lobe_moments", n.size(), Buffer<float>(test_device(), n), out);
        return out.read_all();
    }
    Program program_ = build_probe("probe/brdf_lobe.cl");
};

// J and K from their integrals, split where the lobe bends.
Long moment(Long n, int power) {
    const Long bend = 1 / (1 + n);
    const auto f = [&](Long x) { return std::pow(1 - x, Long(power + 1)) / (1 - x + n * x); };
    Long sum = integrate(f, 0, bend), from = bend;
    for (; from * 8 < 1; from *= 8) sum += integrate(f, from, from * 8);
    return sum + integrate(f, from, 1);
}

// The share of the lobe nearer to its peak than x, times J.
Long cumulated(Long n, Long x) {
    const Long a = n - 1;
    if (std::fabs(a * x) < 1e-3L) {  // sum_k (-a)^k (x^(k+1)/(k+1) - x^(k+2)/(k+2))
        Long sum = 0, power = 1;
        for (int k = 0; k < 12; ++k, power *= -a * x)
            sum += power * (x / (k + 1) - x * x / (k + 2));
        return sum;
    }
    return (n * std::log1p(a * x) - a * x) / (a * a);
}

}  // namespace

TEST_F(BrdfLobe, MomentsKnownValues) {
    const std::vector<float> n = {0, 1, 2, 10, 100, 1e4f, 1e6f, 1e8f};
    const double j[] = {1,
                        .5,
                        .386294361120,
                        .173158653456,
                        .036885727844,
                        8.2120827064e-4,
                        1.2815537189e-5,
                        1.74206811024e-7};
    const double k[] = {.5,
                        1.0 / 3,
                        .272588722240,
                        .136842948285,
                        .032207805903,
                        7.7128539918e-4,
                        1.23155495046e-5};
    const std::vector<float> out = moments(n);
    for (std::size_t i = 0; i < n.size(); ++i) {
        EXPECT_LE(relative_error(out[2 * i], j[i]), 4e-7) << n[i];
        if (i >= std::size(k)) continue;
        EXPECT_LE(relative_error(out[2 * i + 1], k[i]), 4e-7) << n[i];
    }
}

TEST_F(BrdfLobe, MomentsAgainstQuadrature) {
    std::vector<float> n = {1e-30f,    1e-6f,     .05f, .4f,      1 - .34f,  1 - .36f,
                            1 - 1e-4f, one_minus, 1,    one_plus, 1 + 1e-4f, 1.34f,
                            1.36f,     2.499f,    2.5f, 2.501f,   1e12f};
    Random random(21);
    for (int i = 0; i < 300; ++i) n.push_back(float(random.log_uniform(1e-3, 1e9)));
    for (int i = 0; i < 300; ++i) n.push_back(float(random.uniform(0.3, 4)));
    const std::vector<float> out = moments(n);
    double worst_j = 0, worst_k = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        worst_j = std::max(worst_j, relative_error(out[2 * i], moment(n[i], 0)));
        worst_k = std::max(worst_k, relative_error(out[2 * i + 1], moment(n[i], 1)));
    }
    std::printf("  J within %.2e, K within %.2e\n", worst_j, worst_k);
    EXPECT_LE(worst_j, 6e-7);
    EXPECT_LE(worst_k, 1.5e-6);
    for (float value : moments({3e38f, 1e38f, 1e20f})) EXPECT_TRUE(value > 0 && value < 1) << value;
}

TEST_F(BrdfLobe, RationalValues) {
    Random random(22);
    std::vector<float> n, x, t;
    std::vector<Long> exact;
    for (int i = 0; i < 100000; ++i) {
        n.push_back(i % 50 ? float(random.log_uniform(1e-6, 1e12)) : 0);
        x.push_back(float(i % 2 ? random.uniform() : random.log_uniform(1e-12, 1)));
        t.push_back(1 - x.back());
        if (x.back() > 0.5f) x.back() = 1 - t.back();  // exact, as the kernels have it
        exact.push_back((1 - Long(x.back())) / (1 - Long(x.back()) + Long(n.back()) * x.back()));
    }
    const std::vector<float> out = values(n, x, t);
    double worst = 0;
    for (std::size_t i = 0; i < n.size(); ++i)
        if (t[i] > 0) worst = std::max(worst, relative_error(out[2 * i], exact[i]));
    std::printf("  g within %.2e\n", worst);
    EXPECT_LE(worst, 3e-7);
}

// The corners: peak, horizon of the lobe, n at both ends and about one.
TEST_F(BrdfLobe, Corners) {
    const std::vector<float> ns = {0, 1e-30f, 0.1f, one_minus, 1, one_plus, 10, 1e8f, 1e12f, 3e38f};
    const std::size_t count = ns.size();
    auto out = values(ns, std::vector<float>(count, 0), std::vector<float>(count, 1));
    for (float value : out) EXPECT_EQ(value, 1);  // g and t^n at the peak
    for (float t : {0.0f, -1e-30f, -1.0f})
        for (float value :
             values(ns, std::vector<float>(count, 1 - t), std::vector<float>(count, t)))
            EXPECT_EQ(value, 0) << t;
    for (float t : {1e-38f, 1e-20f, 1e-3f, 1.0f}) {
        EXPECT_EQ(values({0}, {1 - t}, {t})[0], 1);  // n = 0: constant where t > 0
        EXPECT_EQ(values({0}, {1 - t}, {t})[1], 1);
        EXPECT_NEAR(values({1}, {1 - t}, {t})[0] / t, 1, 1.2e-7);  // n = 1: the cosine
    }
    for (float n : {0.5f, 1.0f, 10.0f, 1e4f, 1e8f}) {
        const float x = 1 / (1 + n);
        EXPECT_NEAR(values({n}, {x}, {n * x})[0], 0.5, 1e-7) << n;  // t = n / (n + 1)
    }
    for (float n : {1e3f, 1e6f, 1e8f})
        EXPECT_NEAR(values({n}, {1 / n}, {1 - 1 / n})[0], (1 - 1 / n) / (2 - 1 / n), 1e-7);
    // cos^n one step below the peak, far beyond its reach, and down where it underflows.
    EXPECT_NEAR(values({1e8f}, {0x1p-24f}, {one_minus})[1] / .0025787, 1, 1e-4);
    EXPECT_EQ(values({1e38f}, {0x1p-24f}, {one_minus})[1], 0);
    EXPECT_LE(values({150}, {0.5f}, {0.5f})[1], 7.1e-46f + 0x1p-149f);
}

TEST_F(BrdfLobe, InverseKnownValues) {
    struct Row {
        float n;
        double x[3];  // at u = .1, .5, .99
    } rows[] = {{.2f, {.07529586, .3932619, .94128076}},
                {10, {.018926402, .14390865, .82414521}},
                {100, {.004463257, .054911722, .7521702}},
                {1e4f, {1.2732883e-4, .0060027262, .64752369}},
                {1e8f, {4.7091385e-8, 6.0646745e-5, .51969648}}};
    for (const Row& row : rows) {
        const auto out = call("lobe_invert", {row.n, row.n, row.n}, {.1f, .5f, .99f}, 2);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(out[2 * i] / row.x[i], 1, 4e-6) << row.n << " " << i;
    }
    for (float u : {0.0f, 1e-5f, .05f, .3f, .9f, 1 - 0x1p-24f})
        EXPECT_NEAR(call("lobe_invert", {1}, {u}, 2)[1], std::sqrt(1 - u), 1.2e-7);
}

// G(x) = u J, wherever u falls, for all n that are inverted; u = 0 is the peak itself.
TEST_F(BrdfLobe, InverseHasTheRightShareOfTheLobe) {
    Random random(23);
    std::vector<float> n, u;
    for (int i = 0; i < 100000; ++i) {
        n.push_back(float(i % 3 ? random.log_uniform(.05, 1e12) : random.uniform(.06, 4)));
        u.push_back(i % 5 ? random.uniform_float() : float(random.log_uniform(1e-7, 1)));
        if (u.back() >= 1) u.back() = one_minus;
    }
    const auto out = call("lobe_invert", n, u, 2);
    double worst = 0, worst_small = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        ASSERT_TRUE(out[2 * i] >= 0 && out[2 * i] <= 1 && out[2 * i + 1] >= 0)
            << n[i] << " " << u[i];
        const Long j = cumulated(n[i], 1), share = cumulated(n[i], out[2 * i]) / j;
        worst = std::max(worst, std::fabs(double(share - u[i])));
        if (u[i] < .1f) worst_small = std::max(worst_small, relative_error(share, u[i]));
    }
    std::printf("  share of the lobe within %.2e, relative below u = 0.1 within %.2e\n", worst,
                worst_small);
    EXPECT_LE(worst, 1.5e-6);
    EXPECT_LE(worst_small, 2e-6);
    for (float peak : {.05f, .5f, 1.0f, one_plus, 2.0f, 1e4f, 3e38f})
        EXPECT_EQ(call("lobe_invert", {peak}, {0}, 2), (std::vector<float>{0, 1})) << peak;
}

TEST_F(BrdfLobe, PowerPointsInvertThePower) {
    Random random(24);
    std::vector<float> n, u;
    for (int i = 0; i < 100000; ++i) {
        n.push_back(i % 20 ? float(random.log_uniform(1e-6, 1e30)) : 0);
        u.push_back(random.uniform_float());
    }
    const auto out = call("lobe_power_point", n, u, 2);
    double worst_x = 0, worst_t = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        const Long log_t = std::log1p(-Long(u[i])) / (Long(n[i]) + 1);
        worst_x = std::max(worst_x, relative_error(out[2 * i], -std::expm1(log_t)));
        worst_t = std::max(worst_t, relative_error(out[2 * i + 1], std::exp(log_t)));
    }
    std::printf("  x within %.2e, t within %.2e\n", worst_x, worst_t);
    EXPECT_LE(worst_x, 6e-7);
    EXPECT_LE(worst_t, 2e-6);
}

// Two directions 1e-8 to 1 rad apart: x keeps its relative precision down to the rounding of the
// vectors themselves, and the visible arc is what the horizon leaves.
TEST_F(BrdfLobe, GeometryFromVectors) {
    Random random(25);
    std::vector<float> wo, wi;
    std::vector<Long> x, arc;
    for (int i = 0; i < 50000; ++i) {
        const glm::vec3 o(direction(std::acos(Long(random.uniform())), random.uniform(0, 6.28)));
        const vec3l mirror(-o.x, -o.y, o.z);
        const vec3l off = direction(random.uniform(0, 3.1), random.uniform(0, 6.28));
        const glm::vec3 v(glm::normalize(mirror + Long(random.log_uniform(1e-8, 1)) * off));
        const vec3l d = mirror - vec3l(v);
        for (int k = 0; k < 3; ++k) wo.push_back(o[k]), wi.push_back(v[k]);
        x.push_back(0.5L * glm::dot(d, d));
        const Long t = 1 - x.back(), s = std::sqrt(x.back() * (2 - x.back()));
        const Long sine = std::hypot(Long(o.x), Long(o.y));
        arc.push_back(t * o.z >= s * sine ? 1 : std::acos(-t * o.z / (s * sine)) / pi);
    }
    Buffer<float> out(test_device(), wo.size());
    run_probe(program_, "lobe_geometry", x.size(), Buffer<float>(test_device(), wo),
              Buffer<float>(test_device(), wi), out);
    const auto got = out.read_all();
    double worst = 0, worst_arc = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        worst = std::max(worst, x[i] > 0 ? relative_error(got[3 * i], x[i]) : double(got[3 * i]));
        if (got[3 * i + 1] > 0)
            worst_arc = std::max(worst_arc, std::fabs(double(got[3 * i + 2] - arc[i])));
    }
    std::printf("  x within %.2e, arc within %.2e\n", worst, worst_arc);
    EXPECT_LE(worst, 5e-7);
    EXPECT_LE(worst_arc, 2e-3);  // a square root at the circle that just touches the horizon
}
