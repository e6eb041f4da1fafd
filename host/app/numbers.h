// SPDX-License-Identifier: Apache-2.0
// Checks for options that are numbers: what does not fit is an error that says what would.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace lobe {

// Decimal digits only, from `low` to `high`; leading zeros make no octal number.
CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);

// A number from `low` to `high`, which may be infinite; never NaN. `wanted` describes it: "above
// 0".
CLI::Validator real_number(double low, double high, const std::string& wanted);

// "1%" or "0.01", above 0 and at most 100 %; made the plain number.
CLI::Validator part_of_one();

}  // namespace lobe
