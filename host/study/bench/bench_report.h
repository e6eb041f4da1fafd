// SPDX-License-Identifier: Apache-2.0
// The figures of `lobe bench` as text and as JSON, and two of them side by side.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "study/bench/bench.h"

namespace lobe {

std::string to_text(const BenchReport& report);
nlohmann::ordered_json to_json(const BenchReport& report);

// A table of what two files of to_json() both hold, B over A. Throws Error (comparison) if a file
// is not of lobe bench, or if they have nothing in common.
std::string comparison_text(const std::string& file_a, const nlohmann::ordered_json& a,
                            const std::string& file_b, const nlohmann::ordered_json& b);

}  // namespace lobe
