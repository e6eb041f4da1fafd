// SPDX-License-Identifier: Apache-2.0
// The statistics of a render's paths and light samples, as JSON and for a person.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "render/statistics.h"

namespace lobe {

nlohmann::ordered_json to_json(const RenderStatistics& statistics);

// Two lines: "paths    3.10 scattering events on average; ..." and "lights   of the light samples
// 62 % reach, ..."; the second is missing where none was sent for. "" without paths.
std::string to_text(const RenderStatistics& statistics);

}  // namespace lobe
