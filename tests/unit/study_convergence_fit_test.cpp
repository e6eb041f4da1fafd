// SPDX-License-Identifier: Apache-2.0
// The lines and bands of a convergence experiment, on errors whose law is known.
#include "study/convergence_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "study/convergence_report.h"
#include "support/chi_square.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// MSE = v / N^power + b2 with a relative error of each render, and times of c N with theirs.
struct Law {
    double v = 2, b2 = 0, power = 1, noise = 0.06, c = 1e-3, jitter = 0.02;
};

ConvergenceReport report_of(const Law& law, Random& random, unsigned resamples = 200) {
    ConvergenceReport report;
    report.integrator.sampler = Integrator::Sampler::independent;
    report.plan.resamples = resamples;
    report.reference_mean = 1;
    report.seeds = report.plan.seeds;
    for (unsigned k = 0; k < report.plan.levels; ++k) {
        const double n = report.plan.samples(k);
        std::vector<double> mse;
        for (unsigned seed = 0; seed < report.seeds; ++seed) {
            ConvergenceRun run;
            run.level = k;
            run.mse = (law.v / std::pow(n, law.power) + law.b2) * (1 + law.noise * random.normal());
            run.seconds = law.c * n * (1 + law.jitter * random.normal());
            report.runs.push_back(run);
            mse.push_back(run.mse);
        }
        ConvergenceLevel level;
        level.samples = report.plan.samples(k);
        level.mse = studentised_mean(mse);
        report.levels.push_back(level);
    }
    fit_levels(report, 0);
    return report;
}

testing::AssertionResult rate(int found, int trials, double expected, double tests) {
    const double deviation = std::sqrt(expected * (1 - expected) * trials);
    return normal_deviate((found - expected * trials) / deviation, tests)
           << " " << found << " of " << trials;
}

}  // namespace

// Of 95 % bands, 95 in 100 hold the truth, and a bias that is not there is found as often as said.
TEST(ConvergenceFit, BandsCover) {
    Random random(1);
    constexpr int trials = 500;
    int slope = 0, v = 0, b2 = 0, unit = 0, first = 0, alarms = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const ConvergenceReport r = report_of({}, random);
        slope += r.fit.slope_band.holds(-0.5);
        v += r.fit.v_band.holds(2);
        b2 += r.fit.b2_band.holds(0);
        unit += r.fit.unit_variance_band.holds(2e-3);
        first += r.levels[0].mse_band.holds(0.5);
        alarms += r.fit.b2_p < 0.05;
    }
    // Sixteen seeds: the bands are a little narrow, so each may hold only .92.
    for (const int held : {slope, v, b2, first, unit}) EXPECT_GE(held, 0.92 * trials) << held;
    for (const int held : {slope, v, b2, first}) EXPECT_LE(held, 0.98 * trials) << held;
    EXPECT_TRUE(rate(alarms, trials, 0.06, 1));
}

TEST(ConvergenceFit, FindsWhatIsThere) {
    Random random(2);
    const ConvergenceReport clean = report_of({}, random), biased = report_of({2, 4e-4}, random);
    EXPECT_NEAR(clean.fit.power.slope, -0.5, 0.01);
    EXPECT_NEAR(clean.fit.floor.slope, 2, 4 * clean.fit.floor.slope_error);
    EXPECT_LT(std::fabs(clean.fit.floor.intercept), 4 * clean.fit.b2_error);
    EXPECT_NEAR(clean.fit.seconds_per_sample, 1e-3, 1e-5);
    EXPECT_NEAR(clean.fit.unit_variance_seconds, 2e-3, 1e-4);
    EXPECT_GT(clean.fit.floor.p(), 1e-3);
    EXPECT_NEAR(biased.fit.floor.intercept, 4e-4, 4 * biased.fit.b2_error);
    EXPECT_LT(biased.fit.b2_p, 1e-3);
    // Error 1 % of a mean of 1 needs an MSE of 1e-4: 20,000 samples, 20 s.
    EXPECT_NEAR(clean.fit.target_samples / 20000, 1, 0.15);
    EXPECT_NEAR(clean.fit.target_seconds / 20, 1, 0.15);
    const ConvergenceReport steep = report_of({2, 0, 1.3}, random);
    EXPECT_NEAR(steep.fit.power.slope, -0.65, 0.01);
    EXPECT_LT(steep.fit.floor.p(), 1e-6);  // not v / N
}

// What the reference's own error adds makes b2 less certain.
TEST(ConvergenceFit, KnowsTheReferencesError) {
    Random random(3);
    ConvergenceReport r = report_of({2, 4e-4}, random);
    fit_levels(r, 1e-6);
    EXPECT_GT(r.fit.b2_error, 1e-3);
    EXPECT_GT(r.fit.b2_p, 0.05);

    // (e^2 - its estimate) averaged over pixels, e and the estimate from two halves.
    constexpr std::size_t pixels = 400;
    Reference reference;
    const std::vector<bool> masked(pixels);
    double squares = 0, told = 0;
    constexpr int trials = 2000;
    for (int trial = 0; trial < trials; ++trial) {
        reference.luminance_error.assign(pixels, 0);
        double sum = 0;
        for (std::size_t p = 0; p < pixels; ++p) {
            const double sd = 1 + p % 3, a = sd * random.normal(), b = sd * random.normal();
            const double error = (a + b) / 2;
            reference.luminance_error[p] = static_cast<float>(std::fabs(a - b) / 2);
            sum += error * error - std::pow(reference.luminance_error[p], 2);
        }
        squares += std::pow(sum / pixels, 2);
        told += reference_floor_variance(reference, masked);
    }
    EXPECT_NEAR(told / squares, 1, 0.1);
}

// No noise at all, or none above the reference's: nothing is told, nothing breaks.
TEST(ConvergenceFit, NothingToFit) {
    Random random(4);
    for (const Law& law : {Law{0, 0}, Law{2, -1}}) {
        const ConvergenceReport r = report_of(law, random);
        EXPECT_TRUE(std::isnan(r.fit.power.slope));
        EXPECT_TRUE(std::isnan(r.fit.target_seconds));
        EXPECT_TRUE(std::isnan(r.fit.slope_band.low));
        EXPECT_FALSE(judge_bias(r).found);
        EXPECT_NE(to_text(r).find("unknown"), std::string::npos);
        EXPECT_TRUE(
            to_json({"1", {}, {r}})["scenes"][0]["fit"]["target_spp"].dump() == "null" ||
            std::isnan(to_json({"1", {}, {r}})["scenes"][0]["fit"]["target_spp"].get<double>()));
    }
}
