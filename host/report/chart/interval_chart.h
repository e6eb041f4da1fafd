// SPDX-License-Identifier: Apache-2.0
// Estimates with their intervals, one below the other, beside a line that means "no difference".
#pragma once

#include <string>
#include <vector>

#include "report/drawing.h"

namespace lobe {

struct IntervalRow {
    std::string label;
    double low, value, high;
    std::string verdict;  // at the right: "WIN"
};

struct IntervalChart {
    std::string title, x_label;  // "efficiency of A over B"
    std::vector<IntervalRow> rows;
    double neutral = 1;
    bool log = true;  // as ratios want
};

// An interval that leaves the axis ends at its edge; a row that is not finite shows its label only.
Drawing draw(const IntervalChart& chart);

}  // namespace lobe
