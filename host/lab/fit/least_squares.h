// SPDX-License-Identifier: Apache-2.0
// Nonlinear least squares within bounds. The solver is Ceres, in a module of its own that is opened
// only when something is fitted.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace lobe {

struct LeastSquaresProblem {
    std::size_t residuals = 0;
    std::vector<double> start, lowest, highest;  // one an unknown; bounds may be infinite
    int most_iterations = 50;
    bool with_covariance = false;
    // The residuals at x and, unless it is null, their derivatives: row r holds those of residual
    // r.
    std::function<void(const double* x, double* residuals, double* jacobian)> evaluate;
};

struct LeastSquaresSolution {
    std::vector<double> x;
    double sum_of_squares = std::numeric_limits<double>::infinity();  // where it failed
    int iterations = 0;
    bool converged = false;
    // Of x for residuals of variance one, row by row. An unknown that lies at a bound or has no
    // effect on the residuals counts as given: its rows are 0. Empty if the others do not determine
    // each other, or if it was not asked for.
    std::vector<double> covariance;
};

// Throws Error (usage), with what to install, if this build has no solver.
void need_least_squares();

// Throws as need_least_squares, and whatever `evaluate` throws.
LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem);

// Whether the solver can be opened.
bool has_least_squares();

// What the module lobe_fit.so exports as "lobe_solve_least_squares".
using SolveLeastSquares = void (*)(const LeastSquaresProblem& problem,
                                   LeastSquaresSolution& solution);

}  // namespace lobe
