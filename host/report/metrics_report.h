// SPDX-License-Identifier: Apache-2.0
// The figures of a comparison for a person and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "report/metrics.h"

namespace lobe {

// One object; the channels' figures under "channels" by name. What is unknown is null.
nlohmann::ordered_json to_json(const PictureMetrics& metrics);

// A table, a column a channel, and a line each for odd values, left-out pixels, the worst block and
// the tests. `picture` and `reference` name the two sides: "A" and "B".
std::string to_text(const PictureMetrics& metrics, const std::string& picture,
                    const std::string& reference);

}  // namespace lobe
