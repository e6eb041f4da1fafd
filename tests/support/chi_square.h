// SPDX-License-Identifier: Apache-2.0
// Statistical verdicts as assertions, at a family-wise level.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "base/chi_square.h"

namespace lobe::test {

// False alarms of a whole family of tests, in code changes that alter the random numbers.
constexpr double family_alpha = 1e-3;

// Fails where p is below the level that each of `tests` tests has in a family (Sidak).
testing::AssertionResult follows(const std::vector<double>& counts,
                                 const std::vector<double>& expected, double tests,
                                 bool scale = true);

// Fails where z is further from zero than chance allows in a family of `tests` tests.
testing::AssertionResult normal_deviate(double z, double tests);

}  // namespace lobe::test
