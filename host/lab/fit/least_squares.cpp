// SPDX-License-Identifier: Apache-2.0
#include "lab/fit/least_squares.h"

#include "base/error.h"
#include "base/module.h"

namespace lobe {
namespace {

const Module& fit_module() {
    static const Module module("lobe_fit.so");
    return module;
}

SolveLeastSquares solver() {
    return fit_module().function<SolveLeastSquares>("lobe_solve_least_squares");
}

}  // namespace

bool has_least_squares() { return solver() != nullptr; }

void need_least_squares() {
    if (!solver())
        throw Error(ExitCode::usage,
                    "this build cannot fit: lobe_fit.so cannot be opened: " + fit_module().error(),
                    "", "install libceres-dev, then configure and build lobe again");
}

LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem) {
    need_least_squares();
    LeastSquaresSolution solution;
    solver()(problem, solution);
    return solution;
}

}  // namespace lobe
