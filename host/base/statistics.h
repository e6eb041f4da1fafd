// SPDX-License-Identifier: Apache-2.0
// The distributions that error bars and tests need. Tail probabilities are relatively accurate.
#pragma once

#include <cstddef>
#include <vector>

namespace lobe {

double mean(const std::vector<double>& values);             // NaN of none
double sample_variance(const std::vector<double>& values);  // divided by n - 1; NaN below two
double standard_error(const std::vector<double>& values);   // of their mean; NaN below two
double median(std::vector<double> values);                  // NaN of none
// 1.4826 times the median distance of the values from `centre`: for normal values their standard
// deviation. NaN of none.
double deviation_from(std::vector<double> values, double centre);

double normal_cdf(double z);
double normal_quantile(double p);  // -inf at 0, +inf at 1
double two_sided_p(double z);      // probability of a normal deviate at least |z| away from 0

double student_cdf(double t, double freedom);
double student_quantile(double p, double freedom);  // e.g. 0.975 for a 95 % interval

// Probability that a chi-square variable is at least x.
double chi_square_survival(double x, double freedom);

// The level for each of `tests` independent tests so that all together err with probability alpha.
double sidak(double alpha, double tests);

}  // namespace lobe
