// SPDX-License-Identifier: Apache-2.0
// What grows, as text, as JSON and as plots.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/html/report_page.h"
#include "study/bench/growth.h"

namespace lobe {

// A table a series.
std::string to_text(const std::vector<GrowthSeries>& growth);

// An array of series; times in seconds.
nlohmann::ordered_json to_json(const std::vector<GrowthSeries>& growth);

// Time of a sample, time of the build and memory against what grows: a plot and a table each.
ReportSection growth_section(const GrowthSeries& series);

}  // namespace lobe
