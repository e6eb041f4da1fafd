// SPDX-License-Identifier: Apache-2.0
#include "lab/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/random.h"
#include "base/timer.h"
#include "lab/fit/fit_unknowns.h"
#include "lab/fit/least_squares.h"

namespace lobe {
namespace {

constexpr double dark = 1e-3;  // 1/sr, of the logarithmic residual
constexpr std::size_t few_points = 1500;
constexpr int few_iterations = 20, many_iterations = 100;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double balance(const FitPoints& points, std::size_t i) {
    return std::sqrt(points.wo[i].z * points.wi[i].z);
}

double residual(FitWeight weight, double c, double f, double g) {
    if (weight == FitWeight::cosine) return c * (f - g);
    return std::log((dark + c * std::max(f, 0.0)) / (dark + c * g));
}

Brightness brightness_of(const FitPoints& points) {
    Brightness data{};
    for (int k = 0; k < 3; ++k) {
        std::vector<double> values;
        for (const glm::dvec3& f : points.f) values.push_back(f[k]);
        std::sort(values.begin(), values.end());
        data.typical[k] = values[values.size() / 4];
        data.largest[k] = values[values.size() - 1 - values.size() / 1000];
    }
    return data;
}

// Every so manyth point.
FitPoints thinned(const FitPoints& points, std::size_t most) {
    if (points.size() <= most) return points;
    FitPoints few;
    for (std::size_t k = 0; k < most; ++k) {
        const std::size_t i = k * points.size() / most;
        few.wo.push_back(points.wo[i]);
        few.wi.push_back(points.wi[i]);
        few.f.push_back(points.f[i]);
    }
    return few;
}

// The model on the device at all points, for several parameter sets at once.
class Model {
  public:
    Model(BrdfProbe& probe, const Subject& subject, const FitPoints& points)
        : probe_(probe), subject_(subject), points_(points) {}

    // g of set s at point i is element s * points + i.
    std::vector<glm::dvec3> values(const std::vector<BrdfRows>& sets) const {
        probe_.set_parameters(sets, subject_.tables);
        BrdfQuery query;
        for (std::uint32_t set = 0; set < sets.size(); ++set)
            for (std::size_t i = 0; i < points_.size(); ++i)
                query.add(set, points_.wo[i], points_.wi[i]);
        std::vector<glm::dvec3> g;
        g.reserve(query.size());
        for (const BrdfValue& value : probe_.eval(query))
            g.push_back(value.f / query.second[g.size()].z);
        return g;
    }

    std::vector<double> residuals(FitWeight weight, const std::vector<glm::dvec3>& g,
                                  std::size_t set) const {
        std::vector<double> out;
        out.reserve(3 * points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i)
            for (int k = 0; k < 3; ++k)
                out.push_back(residual(weight, balance(points_, i), points_.f[i][k],
                                       g[set * points_.size() + i][k]));
        return out;
    }

    double error(FitWeight weight, const BrdfRows& rows) const {
        double sum = 0;
        for (const double r : residuals(weight, values({rows}), 0)) sum += r * r;
        return std::sqrt(sum / static_cast<double>(3 * points_.size()));
    }

  private:
    BrdfProbe& probe_;
    const Subject& subject_;
    const FitPoints& points_;
};

// Residuals of all points, and their derivatives by differences over steps that the device's floats
// hold exactly: a launch evaluates all of them.
class Residuals {
  public:
    Residuals(BrdfProbe& probe, const Subject& subject, const std::vector<Unknown>& unknowns,
              const FitPoints& points, FitWeight weight)
        : model_(probe, subject, points),
          subject_(subject),
          unknowns_(unknowns),
          weight_(weight),
          step_(probe.precision() == Precision::twice ? 2e-4 : 4e-3) {}

    void operator()(const double* x, double* residuals, double* jacobian) const {
        const std::size_t count = unknowns_.size();
        std::vector<BrdfRows> sets{rows_at(subject_, unknowns_, x)};
        std::vector<double> width;
        for (std::size_t i = 0; jacobian && i < count; ++i) {
            std::vector<double> moved(x, x + count);
            double ends[2];
            for (const int side : {0, 1}) {
                moved[i] = std::clamp(x[i] + (side ? -1 : 1) * step_at(i, x[i]),
                                      unknowns_[i].lowest, unknowns_[i].highest);
                sets.push_back(rows_at(subject_, unknowns_, moved.data()));
                ends[side] = held_at(sets.back(), i);
            }
            width.push_back(ends[0] - ends[1]);
        }
        const std::vector<glm::dvec3> g = model_.values(sets);
        const std::vector<double> here = model_.residuals(weight_, g, 0);
        std::copy(here.begin(), here.end(), residuals);
        for (std::size_t i = 0; jacobian && i < count; ++i) {
            const std::vector<double> above = model_.residuals(weight_, g, 1 + 2 * i);
            const std::vector<double> below = model_.residuals(weight_, g, 2 + 2 * i);
            for (std::size_t r = 0; r < here.size(); ++r)
                jacobian[r * count + i] = width[i] > 0 ? (above[r] - below[r]) / width[i] : 0;
        }
    }

  private:
    double step_at(std::size_t i, double x) const {
        return unknowns_[i].logarithmic ? step_ : step_ * std::max(std::abs(x), 0.01);
    }

    // The optimiser's variable that a row's float stands for.
    double held_at(const BrdfRows& rows, std::size_t i) const {
        const Unknown& u = unknowns_[i];
        return u.x_of(static_cast<double>(rows[u.row][static_cast<std::size_t>(u.channel)]));
    }

    Model model_;
    const Subject& subject_;
    const std::vector<Unknown>& unknowns_;
    FitWeight weight_;
    double step_;
};

LeastSquaresSolution solve(BrdfProbe& probe, const Subject& subject,
                           const std::vector<Unknown>& unknowns, const FitPoints& points,
                           const std::vector<double>& start, FitWeight weight, bool finish) {
    LeastSquaresProblem problem;
    problem.residuals = 3 * points.size();
    problem.start = start;
    for (const Unknown& u : unknowns) {
        problem.lowest.push_back(u.lowest);
        problem.highest.push_back(u.highest);
    }
    problem.most_iterations = finish ? many_iterations : few_iterations;
    problem.with_covariance = finish;
    problem.evaluate = Residuals(probe, subject, unknowns, points, weight);
    return solve_least_squares(problem);
}

std::vector<FittedParameter> describe(const Subject& subject, const std::vector<Unknown>& unknowns,
                                      const LeastSquaresSolution& solution, double variance) {
    std::vector<FittedParameter> parameters;
    const std::size_t count = unknowns.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Unknown& u = unknowns[i];
        if (u.channel == 0) parameters.push_back({subject.model.parameters[u.row].name, {}, {}});
        const double value = u.parameter(solution.x[i]);
        const double of_x = solution.covariance.empty()
                                ? 0
                                : std::sqrt(variance * solution.covariance[i * count + i]);
        const double error = of_x * (u.logarithmic ? value : u.scale);
        parameters.back().value.push_back(value);
        parameters.back().standard_error.push_back(error > 0 ? error : unknown);
    }
    return parameters;
}

}  // namespace

FitPoints choose_points(const MeasuredBrdf& table, const FitOptions& options) {
    const double least = std::cos(glm::radians(options.largest_angle));
    std::vector<std::size_t> candidates;
    for (std::size_t cell = 0; cell < table.cells(); ++cell) {
        const DirectionPair pair = directions_at(table, cell);
        if (std::isfinite(table.values[cell].x) && std::min(pair.wo.z, pair.wi.z) >= least)
            candidates.push_back(cell);
    }
    if (candidates.empty())
        throw Error(ExitCode::scene, "the table has no data within " +
                                         std::to_string(options.largest_angle) +
                                         " degrees of the normal");
    FitPoints points;
    points.candidates = candidates.size();
    const std::size_t count = std::min(options.points, candidates.size());
    Random random(options.seed);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t first = k * candidates.size() / count;
        const std::size_t run = (k + 1) * candidates.size() / count - first;
        const std::size_t cell = candidates[first + random.below(static_cast<std::uint32_t>(run))];
        const DirectionPair pair = directions_at(table, cell);
        points.wo.push_back(pair.wo);
        points.wi.push_back(pair.wi);
        points.f.emplace_back(table.values[cell]);
    }
    return points;
}

ModelFit fit_model(BrdfProbe& probe, const Subject& subject, const std::vector<std::string>& held,
                   const FitPoints& points, const FitOptions& options) {
    const Stopwatch watch;
    const std::vector<Unknown> unknowns = unknowns_of(subject, held, brightness_of(points));
    if (unknowns.empty())
        throw Error(ExitCode::usage, subject.model.name + " has no parameter left to fit", "",
                    "colours and numbers are fitted, but those that --set gives");
    if (3 * points.size() <= unknowns.size())
        throw Error(ExitCode::scene,
                    "there are fewer data than parameters of " + subject.model.name);
    const FitPoints few = thinned(points, few_points);
    std::vector<LeastSquaresSolution> tries;
    for (const std::vector<double>& start : starting_points(unknowns, options.starts, options.seed))
        tries.push_back(solve(probe, subject, unknowns, few, start, options.weight, false));
    std::sort(tries.begin(), tries.end(),
              [](const auto& a, const auto& b) { return a.sum_of_squares < b.sum_of_squares; });
    LeastSquaresSolution best;
    best.sum_of_squares = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < std::min<std::size_t>(2, tries.size()); ++k) {
        LeastSquaresSolution end =
            solve(probe, subject, unknowns, points, tries[k].x, options.weight, true);
        if (end.sum_of_squares < best.sum_of_squares) best = std::move(end);
    }
    if (!std::isfinite(best.sum_of_squares))
        throw Error(ExitCode::comparison, "no start of " + subject.model.name + " could be fitted");
    const double freedom = static_cast<double>(3 * points.size() - unknowns.size());
    ModelFit fit;
    fit.rows = rows_at(subject, unknowns, best.x.data());
    fit.parameters = describe(subject, unknowns, best, best.sum_of_squares / freedom);
    const Model model(probe, subject, points);
    fit.cosine_error = model.error(FitWeight::cosine, fit.rows);
    fit.log_error = model.error(FitWeight::logarithm, fit.rows);
    fit.iterations = best.iterations;
    fit.converged = best.converged;
    fit.seconds = watch.seconds();
    return fit;
}

double size_of(const FitPoints& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 v = balance(points, i) * points.f[i];
        sum += glm::dot(v, v);
    }
    return std::sqrt(sum / static_cast<double>(3 * points.size()));
}

}  // namespace lobe
