// SPDX-License-Identifier: Apache-2.0
// Horizontal bars of stacked parts, and the costs of a run as such.
#pragma once

#include <string>
#include <vector>

#include "report/drawing.h"

namespace lobe {

struct Bar {
    std::string label;
    std::vector<double> values;  // of the parts, not negative
};

struct BarChart {
    std::string title, x_label;      // "seconds"
    std::vector<std::string> parts;  // what the values of every bar are
    std::vector<Bar> bars;
};

// The parts' names stand above, each with its colour; each bar ends with its sum. What is not
// finite or negative counts as 0.
Drawing draw(const BarChart& chart);

}  // namespace lobe
