// SPDX-License-Identifier: Apache-2.0
// Fits of models to their own values with noise: the truth comes back, and as often within the
// stated errors as it should.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/kernel_text.h"
#include "base/random.h"
#include "base/statistics.h"
#include "lab/fit/fit.h"
#include "lab/fit/least_squares.h"
#include "support/chi_square.h"
#include "support/device.h"

using namespace lobe;
using namespace lobe::test;

#define LOBE_NEEDS_FIT() \
    if (!has_least_squares()) GTEST_SKIP() << "this build has no Ceres"

namespace {

class Fitted {
  public:
    Fitted(const std::string& model, const std::vector<std::pair<std::string, double>>& values)
        : subject{table_of(model), {}, {}},
          probe(test_device(), KernelText(), subject.model,
                test_device().info().fp64 ? Precision::twice : Precision::single) {
        subject.rows = brdf_rows(subject.model, values);
    }

    static BrdfTable table_of(const std::string& model) {
        const std::string file = "brdf/" + model + ".h";
        return parse_brdf_table(file, KernelText().read(file));
    }

    Subject subject;
    BrdfProbe probe;
};

// Direction pairs of a grid, with nothing measured there yet.
FitPoints grid_points(std::array<std::uint32_t, 3> counts, const FitOptions& options) {
    MeasuredBrdf table{counts, {}};
    table.values.assign(std::size_t{counts[0]} * counts[1] * counts[2], glm::vec3(0));
    return choose_points(table, options);
}

void fill(FitPoints& points, Fitted& truth) {
    truth.probe.set_parameters({truth.subject.rows}, truth.subject.tables);
    BrdfQuery query;
    for (std::size_t i = 0; i < points.size(); ++i) query.add(0, points.wo[i], points.wi[i]);
    const std::vector<BrdfValue> values = truth.probe.eval(query);
    for (std::size_t i = 0; i < points.size(); ++i) points.f[i] = values[i].f / points.wi[i].z;
}

// Independent errors of the residuals that the weight speaks of.
void disturb(FitPoints& points, FitWeight weight, double deviation, std::uint64_t seed) {
    Random random(seed);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double c = std::sqrt(points.wo[i].z * points.wi[i].z);
        for (int k = 0; k < 3; ++k) {
            const double error = deviation * random.normal();
            points.f[i][k] = weight == FitWeight::cosine
                                 ? points.f[i][k] + error / c
                                 : ((1e-3 + c * points.f[i][k]) * std::exp(error) - 1e-3) / c;
        }
    }
}

const FittedParameter& parameter(const ModelFit& fit, const std::string& name) {
    for (const FittedParameter& p : fit.parameters)
        if (p.name == name) return p;
    throw std::runtime_error("no parameter " + name);
}

// Probability that a count of `trials` is at most `count`.
double binomial_cdf(int count, int trials, double probability) {
    double sum = 0;
    for (int k = 0; k <= count; ++k)
        sum += std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) -
                        std::lgamma(trials - k + 1.0) + k * std::log(probability) +
                        (trials - k) * std::log1p(-probability));
    return std::min(sum, 1.0);
}

// Deviations of all fitted numbers from the truth, in their standard errors.
std::vector<double> deviations(const ModelFit& fit, const Subject& truth) {
    std::vector<double> z;
    for (const FittedParameter& p : fit.parameters) {
        const auto& row = truth.rows[static_cast<std::size_t>(truth.model.find(p.name))];
        for (std::size_t k = 0; k < p.value.size(); ++k)
            z.push_back((p.value[k] - static_cast<double>(row[k])) / p.standard_error[k]);
    }
    return z;
}

}  // namespace

TEST(LabFit, FindsTheTruthWithoutNoise) {
    LOBE_NEEDS_FIT();
    for (const FitWeight weight : {FitWeight::cosine, FitWeight::logarithm})
        for (const char* model : {"rational", "phong", "modified_phong"})
            for (const double n : {3.0, 60.0, 2000.0}) {
                SCOPED_TRACE(std::string(model) + " " + std::to_string(n));
                Fitted truth(model, {{"kd", 0.2}, {"ks", 0.7}, {"n", n}});
                truth.subject.rows[0] = {0.2f, 0.1f, 0.05f, 0};
                FitOptions options;
                options.weight = weight;
                FitPoints points = grid_points({16, 6, 6}, options);
                fill(points, truth);
                Subject subject = truth.subject;
                subject.rows = subject.model.default_rows();
                const ModelFit fit = fit_model(truth.probe, subject, {}, points, options);
                EXPECT_TRUE(fit.converged);
                EXPECT_LT(fit.cosine_error, 1e-5 * size_of(points));
                EXPECT_LT(fit.log_error, 1e-5);
                EXPECT_NEAR(parameter(fit, "n").value[0], n, 1e-3 * n);
                for (int k = 0; k < 3; ++k)
                    EXPECT_NEAR(parameter(fit, "kd").value[k], truth.subject.rows[0][k], 1e-4);
            }
}

TEST(LabFit, FindsTheTruthWithinItsErrors) {
    LOBE_NEEDS_FIT();
    const std::vector<std::pair<std::string, std::vector<std::pair<std::string, double>>>> truths =
        {{"rational", {{"kd", 0.1}, {"ks", 0.5}, {"n", 40}}},
         {"phong", {{"kd", 0.1}, {"ks", 0.5}, {"n", 40}}},
         {"modified_phong", {{"kd", 0.1}, {"ks", 2}, {"n", 300}}},
         {"plastic", {{"kd", 0.1}, {"ks", 0.5}, {"alpha", 0.2}}},
         {"conductor", {{"eta", 0.3}, {"k", 3}, {"alpha_x", 0.3}, {"alpha_y", 0.2}}},
         {"lambert", {{"kd", 0.3}}}};
    std::vector<double> z;
    for (const auto& [model, values] : truths)
        for (const FitWeight weight : {FitWeight::cosine, FitWeight::logarithm}) {
            SCOPED_TRACE(model);
            Fitted truth(model, values);
            FitOptions options;
            options.weight = weight;
            FitPoints points = grid_points({16, 8, 8}, options);
            fill(points, truth);
            disturb(points, weight, weight == FitWeight::cosine ? 0.02 : 0.05, z.size() + 9);
            Subject subject = truth.subject;
            subject.rows = subject.model.default_rows();
            const ModelFit fit = fit_model(truth.probe, subject, {}, points, options);
            const double error =
                weight == FitWeight::cosine ? fit.cosine_error / 0.02 : fit.log_error / 0.05;
            EXPECT_NEAR(error, 1, 0.1);
            for (const double deviation : deviations(fit, truth.subject)) z.push_back(deviation);
        }
    for (const double deviation : z)
        EXPECT_TRUE(normal_deviate(deviation, static_cast<double>(z.size())));
}

// Over many noises, 95 % intervals hold the truth as often as they say, and lean to neither side.
TEST(LabFit, ErrorsCoverAsTheySay) {
    LOBE_NEEDS_FIT();
    constexpr int noises = 50;
    constexpr double tests = 2 * 7 * 2;
    Fitted truth("rational", {{"kd", 0.1}, {"ks", 0.5}, {"n", 20}});
    Subject subject = truth.subject;
    subject.rows = subject.model.default_rows();
    FitOptions options;
    options.starts = 3;
    FitPoints exact = grid_points({10, 5, 6}, options);
    fill(exact, truth);
    for (const FitWeight weight : {FitWeight::cosine, FitWeight::logarithm}) {
        options.weight = weight;
        std::vector<std::vector<double>> z(7);
        for (int noise = 0; noise < noises; ++noise) {
            FitPoints points = exact;
            disturb(points, weight, 0.03, 1000u + static_cast<unsigned>(noise));
            const auto here =
                deviations(fit_model(truth.probe, subject, {}, points, options), truth.subject);
            ASSERT_EQ(here.size(), z.size());
            for (std::size_t i = 0; i < z.size(); ++i) z[i].push_back(here[i]);
        }
        const double limit =
            student_quantile(0.975, static_cast<double>(3 * exact.size() - z.size()));
        for (const std::vector<double>& deviation : z) {
            int covered = 0;
            for (const double d : deviation) covered += std::abs(d) <= limit;
            const double level = sidak(family_alpha, tests);
            EXPECT_GT(2 * binomial_cdf(covered, noises, 0.95), level) << covered;
            EXPECT_GT(2 * (1 - binomial_cdf(covered - 1, noises, 0.95)), level) << covered;
            EXPECT_TRUE(normal_deviate(mean(deviation) * std::sqrt(double(noises)), tests));
            std::printf("  %d of %d, mean deviation %.2f, variance %.2f\n", covered, noises,
                        mean(deviation), sample_variance(deviation));
        }
    }
}

TEST(LabFit, WhatIsHeldStaysAndWhatIsAtABoundHasNoError) {
    LOBE_NEEDS_FIT();
    Fitted truth("modified_phong", {{"kd", 0.1}, {"ks", 0}, {"n", 20}});
    FitOptions options;
    FitPoints points = grid_points({10, 6, 8}, options);
    fill(points, truth);
    disturb(points, FitWeight::cosine, 0.01, 5);
    Subject subject = truth.subject;
    subject.rows = brdf_rows(subject.model, {{"n", 30}});
    const ModelFit fit = fit_model(truth.probe, subject, {"n"}, points, options);
    ASSERT_EQ(fit.parameters.size(), 2u);
    EXPECT_EQ(fit.rows[2][0], 30);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(parameter(fit, "kd").value[k], 0.1, 0.01);
        const FittedParameter& ks = parameter(fit, "ks");
        EXPECT_TRUE(std::isnan(ks.standard_error[k]) ? ks.value[k] == 0 : ks.value[k] < 0.01);
    }
    EXPECT_THROW(fit_model(truth.probe, subject, {"kd", "ks", "n"}, points, options), Error);
}

// A parameter that the others leave no trace of: n where ks is held at 0.
TEST(LabFit, WithoutEffectThereIsNoError) {
    LOBE_NEEDS_FIT();
    Fitted truth("modified_phong", {{"kd", 0.1}, {"ks", 0}, {"n", 20}});
    FitOptions options;
    FitPoints points = grid_points({10, 6, 8}, options);
    fill(points, truth);
    disturb(points, FitWeight::cosine, 0.01, 5);
    const ModelFit fit = fit_model(truth.probe, truth.subject, {"ks"}, points, options);
    EXPECT_TRUE(std::isnan(parameter(fit, "n").standard_error[0]));
    EXPECT_GT(parameter(fit, "kd").standard_error[0], 0);
    EXPECT_NEAR(parameter(fit, "kd").value[0], 0.1, 0.005);
}

TEST(LabFit, PointsAreSpreadOverTheTable) {
    FitOptions options;
    options.points = 500;
    const FitPoints points = grid_points({30, 10, 12}, options);
    EXPECT_EQ(points.size(), 500u);
    EXPECT_GT(points.candidates, 1000u);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_GE(std::min(points.wo[i].z, points.wi[i].z), std::cos(80 * 0.017453292519943));
    MeasuredBrdf none{{2, 2, 2}, std::vector<glm::vec3>(8, glm::vec3(NAN))};
    EXPECT_THROW(choose_points(none, options), Error);
}

TEST(LeastSquares, RosenbrocksValleyWithinBounds) {
    LOBE_NEEDS_FIT();
    LeastSquaresProblem problem;
    problem.residuals = 2;
    problem.start = {-1.2, 1};
    problem.lowest = {-INFINITY, -INFINITY};
    problem.highest = {INFINITY, INFINITY};
    problem.with_covariance = true;
    problem.evaluate = [](const double* x, double* r, double* jacobian) {
        r[0] = 10 * (x[1] - x[0] * x[0]);
        r[1] = 1 - x[0];
        if (!jacobian) return;
        jacobian[0] = -20 * x[0];
        jacobian[1] = 10;
        jacobian[2] = -1;
        jacobian[3] = 0;
    };
    LeastSquaresSolution solution = solve_least_squares(problem);
    EXPECT_TRUE(solution.converged);
    EXPECT_NEAR(solution.x[0], 1, 1e-6);
    EXPECT_NEAR(solution.x[1], 1, 1e-6);
    // (J^T J)^-1 of J = (-20 10; -1 0)
    ASSERT_EQ(solution.covariance.size(), 4u);
    EXPECT_NEAR(solution.covariance[0], 1, 1e-5);
    EXPECT_NEAR(solution.covariance[1], 2, 1e-5);
    EXPECT_NEAR(solution.covariance[3], 4.01, 1e-4);
    problem.highest[0] = 0.5;
    solution = solve_least_squares(problem);
    EXPECT_NEAR(solution.x[0], 0.5, 1e-9);
    EXPECT_NEAR(solution.x[1], 0.25, 1e-6);
    EXPECT_EQ(solution.covariance[0], 0);
    EXPECT_NEAR(solution.covariance[3], 0.01, 1e-6);
}

TEST(LeastSquares, FaultsOfTheResidualsArePassedOn) {
    LOBE_NEEDS_FIT();
    LeastSquaresProblem problem;
    problem.residuals = 1;
    problem.start = problem.lowest = {0};
    problem.highest = {1};
    problem.evaluate = [](const double*, double*, double*) {
        throw Error(ExitCode::device, "the device is gone");
    };
    EXPECT_THROW(solve_least_squares(problem), Error);
    problem.evaluate = [](const double*, double* r, double* jacobian) {
        r[0] = NAN;
        if (jacobian) jacobian[0] = NAN;
    };
    EXPECT_TRUE(std::isinf(solve_least_squares(problem).sum_of_squares));
}

TEST(LeastSquares, ALoneUnknownAtItsBound) {
    LOBE_NEEDS_FIT();
    LeastSquaresProblem problem;
    problem.residuals = 1;
    problem.start = {0.5};
    problem.lowest = {0};
    problem.highest = {1};
    problem.with_covariance = true;
    problem.evaluate = [](const double* x, double* r, double* jacobian) {
        r[0] = x[0] + 1;
        if (jacobian) jacobian[0] = 1;
    };
    const LeastSquaresSolution solution = solve_least_squares(problem);
    EXPECT_TRUE(solution.converged);
    EXPECT_EQ(solution.x[0], 0);
    EXPECT_NEAR(solution.sum_of_squares, 1, 1e-12);
    EXPECT_TRUE(solution.covariance.empty() || solution.covariance[0] == 0);
}
