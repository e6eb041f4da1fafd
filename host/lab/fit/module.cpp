// SPDX-License-Identifier: Apache-2.0
// The fitting module: the only part of lobe that links Ceres (S. Agarwal, K. Mierle et al., "Ceres
// Solver").
#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "lab/fit/least_squares.h"

namespace {

using lobe::LeastSquaresProblem;
using lobe::LeastSquaresSolution;

// A block of size one for each unknown, so that each can be held on its own.
class Cost : public ceres::CostFunction {
  public:
    Cost(const LeastSquaresProblem& problem, std::exception_ptr& fault)
        : problem_(problem), fault_(fault), unknowns_(problem.start.size()) {
        set_num_residuals(static_cast<int>(problem.residuals));
        mutable_parameter_block_sizes()->assign(unknowns_, 1);
    }

    bool Evaluate(double const* const* blocks, double* residuals,
                  double** jacobians) const override {
        std::vector<double> x(unknowns_), rows;
        for (std::size_t i = 0; i < unknowns_; ++i) x[i] = *blocks[i];
        if (jacobians) rows.resize(problem_.residuals * unknowns_);
        try {
            problem_.evaluate(x.data(), residuals, jacobians ? rows.data() : nullptr);
        } catch (...) {
            fault_ = std::current_exception();
            return false;
        }
        for (std::size_t i = 0; jacobians && i < unknowns_; ++i)
            for (std::size_t r = 0; jacobians[i] && r < problem_.residuals; ++r)
                jacobians[i][r] = rows[r * unknowns_ + i];
        return std::all_of(residuals, residuals + problem_.residuals,
                           [](double r) { return std::isfinite(r); });
    }

  private:
    const LeastSquaresProblem& problem_;
    std::exception_ptr& fault_;
    std::size_t unknowns_;
};

// Holds the unknowns at their bounds; whether there are any.
bool hold_at_bounds(const LeastSquaresProblem& problem, ceres::Problem& ceres_problem,
                    std::vector<double>& x) {
    bool any = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double near = 1e-9 * (1 + std::abs(x[i]));
        if (x[i] - problem.lowest[i] > near && problem.highest[i] - x[i] > near) continue;
        ceres_problem.SetParameterBlockConstant(&x[i]);
        any = true;
    }
    return any;
}

// Unknowns whose change changes nothing.
std::vector<char> without_effect(const LeastSquaresProblem& problem, const std::vector<double>& x) {
    const std::size_t count = x.size();
    std::vector<double> residuals(problem.residuals), jacobian(problem.residuals * count);
    problem.evaluate(x.data(), residuals.data(), jacobian.data());
    std::vector<double> squares(count, 0);
    for (std::size_t k = 0; k < jacobian.size(); ++k)
        squares[k % count] += jacobian[k] * jacobian[k];
    const double largest = *std::max_element(squares.begin(), squares.end());
    std::vector<char> none(count);
    for (std::size_t i = 0; i < count; ++i) none[i] = !(squares[i] > 1e-20 * largest);
    return none;
}

void find_covariance(const LeastSquaresProblem& problem, ceres::Problem& ceres_problem,
                     LeastSquaresSolution& solution) {
    const std::size_t count = solution.x.size();
    const std::vector<char> none = without_effect(problem, solution.x);
    std::vector<const double*> blocks;
    for (std::size_t i = 0; i < count; ++i) {
        if (none[i]) ceres_problem.SetParameterBlockConstant(&solution.x[i]);
        blocks.push_back(&solution.x[i]);
    }
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::DENSE_SVD;
    ceres::Covariance covariance(options);
    if (!covariance.Compute(blocks, &ceres_problem)) return;
    solution.covariance.resize(count * count);
    if (!covariance.GetCovarianceMatrix(blocks, solution.covariance.data()))
        solution.covariance.clear();
}

int steps(const ceres::Solver::Summary& summary) {
    return summary.num_successful_steps + summary.num_unsuccessful_steps;
}

}  // namespace

extern "C" void lobe_solve_least_squares(const LeastSquaresProblem& problem,
                                         LeastSquaresSolution& solution) {
    FLAGS_minloglevel = google::GLOG_FATAL;  // what goes wrong is returned, not written
    std::exception_ptr fault;
    solution.x = problem.start;
    ceres::Problem ceres_problem;
    std::vector<double*> blocks;
    for (double& x : solution.x) blocks.push_back(&x);
    ceres_problem.AddResidualBlock(new Cost(problem, fault), nullptr, blocks);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (std::isfinite(problem.lowest[i]))
            ceres_problem.SetParameterLowerBound(blocks[i], 0, problem.lowest[i]);
        if (std::isfinite(problem.highest[i]))
            ceres_problem.SetParameterUpperBound(blocks[i], 0, problem.highest[i]);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = problem.most_iterations;
    options.function_tolerance = 1e-10;
    options.parameter_tolerance = 1e-8;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &ceres_problem, &summary);
    solution.iterations = steps(summary);
    // Along a bound Ceres' steps are short; with what lies there held, they are not.
    if (!fault && summary.IsSolutionUsable() &&
        hold_at_bounds(problem, ceres_problem, solution.x)) {
        ceres::Solve(options, &ceres_problem, &summary);
        solution.iterations += steps(summary);
    }
    if (fault) std::rethrow_exception(fault);
    if (!summary.IsSolutionUsable()) return;
    solution.converged = summary.termination_type == ceres::CONVERGENCE;
    solution.sum_of_squares = 2 * summary.final_cost;
    if (problem.with_covariance) find_covariance(problem, ceres_problem, solution);
    if (fault) std::rethrow_exception(fault);
}
