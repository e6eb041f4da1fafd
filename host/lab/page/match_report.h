// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lab/measure/matching.h"

namespace lobe {

// The matches of one model to another, for people and as JSON; a dash or null where no value of the
// parameter will do.
std::string to_text(const std::vector<Match>& matches, const Sharpened& own,
                    const Sharpened& other);
nlohmann::ordered_json to_json(const std::vector<Match>& matches, const Sharpened& own,
                               const Sharpened& other);

}  // namespace lobe
