// SPDX-License-Identifier: Apache-2.0
// Curves with bands on two axes: error against time, error against samples.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/drawing.h"

namespace lobe {

struct ChartSeries {
    std::string label;               // stands at the curve
    std::vector<glm::dvec2> points;  // x ascending
    std::vector<glm::dvec2> band;    // low and high of y at each point; empty: none
};

struct LineChart {
    std::string title, x_label, y_label;  // units in the labels: "rendering time (s)"
    std::vector<ChartSeries> series;
    bool log_x = true, log_y = true;
    // A dashed line of this slope behind the curves: -0.5 is the error of independent samples.
    // Only where both axes are logarithmic.
    std::optional<double> guide_slope;
    std::optional<double> level;  // a horizontal line: a target
};

// Points that an axis cannot show (not finite; not positive on a logarithmic one) break their
// curve; a band that reaches below what the axis can show ends at its edge.
Drawing draw(const LineChart& chart);

}  // namespace lobe
