// SPDX-License-Identifier: Apache-2.0
// The lines through the levels of a convergence experiment, with their bands.
#pragma once

#include "study/convergence.h"

namespace lobe {

// Fills report.fit and the bands of report.levels from its levels, runs and reference.
// `floor_variance` is the variance of what the reference's own error adds to every level's mse.
void fit_levels(ConvergenceReport& report, double floor_variance);

// The variance of the mean over pixels of (R - E R)^2 less its estimate, as normal errors have it:
// for K replicates 2 K / (K + 1) / P^2 times the sum of the estimated variances squared.
double reference_floor_variance(const Reference& reference, const std::vector<bool>& masked);

}  // namespace lobe
