// SPDX-License-Identifier: Apache-2.0
#include "support/chi_square.h"

#include <cmath>

#include "base/statistics.h"

namespace lobe::test {

testing::AssertionResult follows(const std::vector<double>& counts,
                                 const std::vector<double>& expected, double tests, bool scale) {
    const ChiSquare result = chi_square(counts, expected, scale);
    const double level = sidak(family_alpha, tests);
    auto verdict = result.p >= level ? testing::AssertionSuccess() : testing::AssertionFailure();
    return verdict << "chi-square " << result.statistic << " with " << result.freedom
                   << " degrees of freedom, p = " << result.p << ", level " << level;
}

testing::AssertionResult normal_deviate(double z, double tests) {
    const double p = two_sided_p(z), level = sidak(family_alpha, tests);
    auto verdict = p >= level ? testing::AssertionSuccess() : testing::AssertionFailure();
    return verdict << "z = " << z << ", p = " << p << ", level " << level;
}

}  // namespace lobe::test
