// SPDX-License-Identifier: Apache-2.0
// What the pages of experiments share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/bootstrap.h"
#include "report/html/report_page.h"
#include "study/arm.h"

namespace lobe {

// As people read it; "-" unless finite.
std::string shown(double value, const char* format = "%.3g");
// "0.98 to 1.02"; "-" unless known.
std::string shown(const Interval& interval, const char* format = "%.3g");
// All digits, for a CSV; "" unless finite.
std::string exact(double value);

// The rows of a CSV (RFC 4180) that has no line ends within cells.
std::vector<std::vector<std::string>> csv_rows(const std::string& csv);

// Steps to a picture, in seconds: a bar and a row for each name.
struct NamedCosts {
    std::string name;
    StartUp start_up;
    double render = 0;
};
void add_costs(ReportSection& section, const std::string& title,
               const std::vector<NamedCosts>& costs);

// "1 to 20".
std::string seed_range(std::uint64_t first, std::uint64_t last);

}  // namespace lobe
