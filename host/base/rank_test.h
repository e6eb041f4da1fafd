// SPDX-License-Identifier: Apache-2.0
// Tests of paired differences: Student's interval, Wilcoxon's ranks, and many tests at once.
#pragma once

#include <cstddef>
#include <vector>

namespace lobe {

// The mean of normal deviates by Student's t, with n - 1 degrees of freedom.
struct MeanInterval {
    double mean = 0, deviation = 0;  // sample standard deviation of one value
    double lo = 0, hi = 0;           // holds the true mean with the confidence asked for
    double p = 1;                    // two-sided, that the true mean is 0
};

// NaN below two values. Values that are all the same give an interval of no width.
MeanInterval mean_interval(const std::vector<double>& values, double confidence = 0.95);

// Two-sided p that the differences lie evenly around 0 (Wilcoxon, "Individual comparisons by
// ranking methods", 1945). Zeros are left out and equal sizes share their mean rank. Exact for up
// to 50 differences, ties or not; beyond by the normal distribution with the variance lessened for
// ties and a half rank of continuity. 1 of none.
double signed_rank_p(const std::vector<double>& differences);

// Holm's adjustment ("A simple sequentially rejective multiple test procedure", 1979): those that
// stay below a level are false alarms, even one of them, with no more than that probability.
std::vector<double> holm(const std::vector<double>& p);

// The level at which Holm's procedure looks at each p, to reject at `alpha` over all: alpha over
// the number of p that are not smaller. Equal p go by their order.
std::vector<double> holm_levels(const std::vector<double>& p, double alpha);

}  // namespace lobe
