// SPDX-License-Identifier: Apache-2.0
// Known numbers of sampling: how the rational lobe's energy is spread, how exactly it is inverted,
// how much of it is visible, and how much the weights of samples vary. Closed forms and integrals
// in 40 digits.
#include <gtest/gtest.h>

#include "base/random.h"
#include "kernel/brdf_numbers.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const double two_pi = 2 * static_cast<double>(pi);

class BrdfNumbersLobe : public testing::Test {
  protected:
    // out: x, t of each
    std::vector<float> invert(const std::vector<float>& n, const std::vector<float>& u,
                              const char* kernel = "lobe_invert") {
        Buffer<float> out(test_device(), 2 * n.size());
        run_probe(program_, kernel, n.size(), Buffer<float>(test_device(), n),
                  Buffer<float>(test_device(), u), out);
        return out.read_all();
    }
    double j(float n) {
        Buffer<float> out(test_device(), 2);
        run_probe(program_, "lobe_moments", 1, Buffer<float>(test_device(), std::vector<float>{n}),
                  out);
        return out.read_all()[0];
    }
    // The angle from the mirror direction within which a share u of the lobe lies, in degrees.
    double angle(float n, float u) {
        const double x = invert({n}, {u})[0];
        return 2 * std::asin(std::sqrt(x / 2)) * 180 / static_cast<double>(pi);
    }
    Program program_ = build_probe("probe/brdf_lobe.cl");
};

Long area_of(Long n) {  // J
    const Long a = n - 1;
    return (n * std::log(n) - a) / (a * a);
}

// The share of the lobe nearer to its peak than x, times J.
Long cumulated(Long n, Long x) {
    const Long a = n - 1;
    if (std::fabs(a * x) < 1e-3L) {
        Long sum = 0, power = 1;
        for (int k = 0; k < 12; ++k, power *= -a * x)
            sum += power * (x / (k + 1) - x * x / (k + 2));
        return sum;
    }
    return (n * std::log1p(a * x) - a * x) / (a * a);
}

}  // namespace

// The mean cosine over the lobe: what a sampler of 1 / (n - (n-1) t) accepts, J (n - 1) / ln n.
TEST_F(BrdfNumbersLobe, EfficiencyOfTheProxy) {
    for (const char* line : {"10 .677", "100 .793", "1e3 .856", "1e5 .913", "1e8 .946", ".5 .44",
                             ".1 .32", ".01 .21"}) {
        const auto row = words(line);
        const double n = std::atof(row[0].c_str());
        EXPECT_TRUE(has_digits(j(static_cast<float>(n)) * (n - 1) / std::log(n), row[1])) << line;
    }
    EXPECT_TRUE(has_digits(j(1), ".5"));
}

// J ~ (ln n - 1) / n.
TEST_F(BrdfNumbersLobe, AreaOfSharpLobes) {
    EXPECT_NEAR(j(1e4f) * 1e4 / (std::log(1e4) - 1), 1.0002122, 1e-6);
    EXPECT_NEAR(j(1e8f) * 1e8 / (std::log(1e8) - 1), 1, 1e-6);
    EXPECT_NEAR(j(1e12f) * double(1e12f) / (std::log(1e12) - 1), 1, 1e-6);
}

// Angles that hold half of the lobe and 90 percent of it; the tail falls so slowly that even the
// largest n leaves 3.7 percent beyond 10 degrees.
TEST_F(BrdfNumbersLobe, HalfAnglesAndTails) {
    for (const char* line : {"100 19.1 50.6", "1e4 6.28 36.6", "1e6 2.0 27.7", "1e8 .63 21.4"}) {
        const auto row = words(line);
        const auto n = static_cast<float>(std::atof(row[0].c_str()));
        EXPECT_TRUE(has_digits(angle(n, 0.5f), row[1])) << line;
        EXPECT_TRUE(has_digits(angle(n, 0.9f), row[2])) << line;
    }
    // (x - 1 - ln x) / (ln n - 1) of the lobe lies beyond x.
    const double x = 1 - std::cos(10 * static_cast<double>(pi) / 180);
    const double beyond = (x - 1 - std::log(x)) / (std::log(double(3e38f)) - 1);
    EXPECT_TRUE(has_digits(100 * beyond, "3.7"));
    EXPECT_NEAR(angle(3e38f, static_cast<float>(1 - beyond)), 10, 1e-3);
}

// Errors of the inverse: of x below u = 0.1, of x and t above, and of the share of the lobe.
// Published figures for a version with iterations are 4.6e-7, 6.0e-6, 1.8e-6 and 4.3e-7.
TEST_F(BrdfNumbersLobe, PrecisionOfTheInverse) {
    Random random(51);
    std::vector<float> n, u;
    for (int i = 0; i < 200000; ++i) {
        n.push_back(float(i % 3 ? random.log_uniform(.05, 1e12) : random.uniform(.06, 4)));
        u.push_back(i % 2 ? random.uniform_float() : float(random.log_uniform(1e-7, .999)));
    }
    const auto out = invert(n, u);
    double near = 0, x_far = 0, t_far = 0, share = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        const Long a = Long(n[i]) - 1, x = out[2 * i], t = out[2 * i + 1];
        const Long j = std::fabs(a) < 1e-3L ? cumulated(n[i], 1) : area_of(n[i]);
        // The exact x is one step of Newton's away, seen from x or, towards the rim, from t.
        const Long from = t < 0.5L ? 1 - t : x;
        const Long missed = cumulated(n[i], from) - u[i] * j;
        const Long step = missed / ((1 - from) / (1 + a * from));
        const auto of_x = double(std::fabs((x - (from - step)) / (from - step)));
        const auto of_t = double(std::fabs((t - (1 - from + step)) / (1 - from + step)));
        if (u[i] < .1f) near = std::max(near, of_x);
        if (u[i] >= .1f) x_far = std::max(x_far, of_x);
        if (u[i] >= .1f) t_far = std::max(t_far, of_t);
        share = std::max(share, double(std::fabs(missed / j)));
    }
    std::printf("  x below u = 0.1 within %.1e, above %.1e; t %.1e; share %.1e\n", near, x_far,
                t_far, share);
    EXPECT_LE(near, 2e-6);
    EXPECT_LE(x_far, 8e-6);
    EXPECT_LE(t_far, 2e-6);
    EXPECT_LE(share, 1e-6);
}

// The part of a lobe that lies above the horizon, at 45, 80 and 89 degrees.
TEST(BrdfNumbersSampling, VisibleFractions) {
    const ModelProbe<float> rational("rational"), power("modified_phong");
    const auto check = [](const ModelProbe<float>& probe, const char* line, bool is_rational) {
        const auto row = words(line);
        const double n = std::atof(row[0].c_str()), degrees[] = {45, 80, 89};
        const double j = !is_rational ? 1 / (n + 1) : n == 1 ? .5 : double(area_of(n));
        for (int i = 0; i < 3; ++i) {
            const auto found = integrals_at(probe, {{"kd", 0}, {"ks", 1}, {"n", n}}, degrees[i], n);
            EXPECT_TRUE(has_digits(found.lobe / (two_pi * j), row[i + 1], 2e-5))
                << probe.name() << " n " << n << " at " << degrees[i];
        }
    };
    for (const char* line : {"1 .854 .587 .509", "10 .929 .642 .515", "100 .964 .735 .529",
                             "1e3 .977 .818 .561", "1e5 .987 .897 .695"})
        check(rational, line, true);
    for (const char* line : {"10 .997 .715 .523", "100 1.000 .960 .569", "1e3 1.000 1.000 .710"})
        check(power, line, false);
}

namespace {

// The furnace: a diffuse albedo of a quarter, a specular one of a half at normal incidence.
BrdfValues furnace(double n) { return {{"kd", .25}, {"ks", .5}, {"n", n}, {"normalize", 1}}; }

}  // namespace

// Standard deviation of one sample's weight over its mean, in percent, at normal incidence: two
// thirds of the samples from the lobe.
TEST(BrdfNumbersSampling, DeviationAtNormalIncidence) {
    const double ns[] = {10, 100, 1e3, 1e5};
    const ModelProbe<float> rational("rational"), modified("modified_phong"), phong("phong");
    const auto exact = words("15.5 10.6 7.9 5.1"), of_power = words("5.0 0.7 0.1 0.0");
    for (int i = 0; i < 4; ++i) {
        const double n = ns[i];
        EXPECT_TRUE(
            has_digits(integrals_at(rational, furnace(n), 0, n).deviation(), exact[i], 1e-3))
            << n;
        EXPECT_NEAR(integrals_at(modified, furnace(n), 0, n).deviation(),
                    std::atof(of_power[i].c_str()), 0.3)
            << n;
        // Its lobe's share comes from an estimate of what is visible, 1 percent off at n = 10.
        EXPECT_LE(integrals_at(phong, furnace(n), 0, n).deviation(), 1.0) << n;
    }
}

// At 80 degrees, samples over the visible arc only. With the exact albedo for the lobe's share it
// would be 27.6, 25.6, 22.6 and 16.8; lobe's share comes from a line between the albedos at the
// ends.
TEST(BrdfNumbersSampling, DeviationAtGrazingAngles) {
    const ModelProbe<float> rational("rational"), phong("phong");
    const double ns[] = {10, 100, 1e3, 1e5};
    const auto expected = words("28.9 27.5 24.3 17.4");
    for (int i = 0; i < 4; ++i)
        EXPECT_TRUE(has_digits(integrals_at(rational, furnace(ns[i]), 80, ns[i]).deviation(),
                               expected[i], 1e-3))
            << ns[i];
    EXPECT_TRUE(has_digits(integrals_at(phong, furnace(10), 80, 10).deviation(), "14.9", 1e-3));
}

// What samples of the cosine alone would cost at 45 degrees: the reason not to take them.
TEST(BrdfNumbersSampling, DeviationOfCosineSamples) {
    struct {
        double n;
        const char *rational, *modified;
    } const rows[] = {{10, "69.1", "111.5"},
                      {100, "132.7", "348.6"},
                      {1e3, "277.6", "1101.6"},
                      {1e5, "1551.0", "11014.6"}};
    const ModelProbe<float> rational("rational"), modified("modified_phong");
    for (const auto& row : rows) {
        EXPECT_TRUE(has_digits(integrals_at(rational, furnace(row.n), 45, row.n).cosine_deviation(),
                               row.rational, 2e-5))
            << row.n;
        EXPECT_TRUE(has_digits(integrals_at(modified, furnace(row.n), 45, row.n).cosine_deviation(),
                               row.modified, 2e-5))
            << row.n;
    }
}

// For Phong's model their variance is infinite: towards the horizon f cos stays what it is, so that
// every decade of cosines adds the same to the mean square.
TEST(BrdfNumbersSampling, CosineSamplesOfPhongHaveInfiniteVariance) {
    const ModelProbe<float> phong("phong");
    const vec3l wo = direction(radians(89));
    // The part of the mean square that cosines from low to high add.
    const auto part = [&](Long low, Long high) {
        const QuadratureRule rule = gauss_rule(48);
        std::vector<vec3l> wi;
        std::vector<double> weights;
        for (std::size_t k = 0; k < rule.node.size(); ++k)
            for (int i = 0; i < 256; ++i) {
                const Long cosine = low * std::pow(high / low, rule.node[k]);
                wi.push_back(direction(std::acos(cosine), 2 * pi * (i + 0.5L) / 256));
                weights.push_back(static_cast<double>(rule.weight[k]) / 256);
            }
        double sum = 0;
        const auto out = phong.eval({furnace(10)}, std::vector<vec3l>(wi.size(), wo), wi);
        for (std::size_t i = 0; i < out.size(); ++i) sum += weights[i] * out[i].f.x * out[i].f.x;
        return sum * two_pi * static_cast<double>(pi * std::log(high / low));
    };
    const double decade = part(1e-12L, 1e-11L);
    EXPECT_NEAR(part(1e-8L, 1e-7L) / decade, 1, 1e-6);
    EXPECT_NEAR(part(1e-5L, 1e-4L) / decade, 1, 1e-3);
    // In percent of the mean: what is seen above a cosine of 0.01, and of 1e-6.
    const double albedo = integrals_at(phong, furnace(10), 89, 10).albedo;
    const double seen = part(0.01L, 0.1L) + part(0.1L, 1);
    const auto percent = [&](double squares) {
        return 100 * std::sqrt(squares / (albedo * albedo) - 1);
    };
    EXPECT_NEAR(percent(seen), 402.3, 0.5);
    EXPECT_NEAR(percent(seen + part(1e-6L, 1e-2L)), 793.9, 0.5);
}
