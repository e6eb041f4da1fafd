// SPDX-License-Identifier: Apache-2.0
// Straight lines through measured points.
#pragma once

#include <vector>

namespace lobe {

// y = intercept + slope x, with what the points' own errors make of it.
struct LineFit {
    double slope = 0, intercept = 0;
    double slope_error = 0, intercept_error = 0, covariance = 0;  // standard errors; of the two
    double chi_square = 0;  // sum of squared residuals, each over its variance
    double freedom = 0;     // of that: points - 2

    double at(double x) const { return intercept + slope * x; }
    // Standard error of at(x).
    double error_at(double x) const;
    // Probability that errors as large as stated leave such residuals or greater: small where the
    // points lie on no line. 1 for two points.
    double p() const;
};

// The least squares line, each point weighed by one over its variance. The errors are those of
// points whose variances are as given, whatever the residuals. MSE_k = v / N_k + b2 is the line of
// slope v and intercept b2 over x = 1 / N. All NaN with fewer than two places, or a variance that
// is not above zero.
LineFit fit_line(const std::vector<double>& x, const std::vector<double>& y,
                 const std::vector<double>& variance);

// The median of the slopes between all pairs of points of different x (Theil 1950, Sen 1968): up to
// 29 % of the points may lie anywhere. NaN without such a pair.
double theil_sen_slope(const std::vector<double>& x, const std::vector<double>& y);

// The median of y - slope x, which goes with it.
double theil_sen_intercept(const std::vector<double>& x, const std::vector<double>& y,
                           double slope);

}  // namespace lobe
