// SPDX-License-Identifier: Apache-2.0
// Does a histogram follow the distribution it should? For any sampler with a density.
#pragma once

#include <gtest/gtest.h>

#include <vector>

namespace lobe::test {

// False alarms of a whole family of tests, in code changes that alter the random numbers.
constexpr double family_alpha = 1e-3;

struct ChiSquare {
    double statistic, freedom, p;
};

// Pearson's test of counts against expected counts. Cells that expect fewer than five are taken
// together; a sample where none can be gives p = 0. `expected` is scaled to the sum of the counts
// unless `scale` is false (then lost samples count against the sampler, and no degree is taken).
ChiSquare chi_square(const std::vector<double>& counts, std::vector<double> expected,
                     bool scale = true);

// Fails where p is below the level that each of `tests` tests has in a family (Sidak).
testing::AssertionResult follows(const std::vector<double>& counts,
                                 const std::vector<double>& expected, double tests,
                                 bool scale = true);

// Fails where z is further from zero than chance allows in a family of `tests` tests.
testing::AssertionResult normal_deviate(double z, double tests);

}  // namespace lobe::test
