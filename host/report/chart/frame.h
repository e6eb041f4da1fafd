// SPDX-License-Identifier: Apache-2.0
// The rectangle of a chart with its two axes, and what all charts write around it.
#pragma once

#include "report/chart/plot_style.h"

namespace lobe {

struct ChartFrame {
    Axis x{}, y{};

    // Axes with grid and numbers, the axes' names and the chart's title.
    void draw(Drawing& drawing, const std::string& title, const std::string& x_label,
              const std::string& y_label) const;

    // The part of a segment within the rectangle, in positions; false if there is none
    // (Y.-D. Liang, B. Barsky, 1984).
    bool clip(glm::dvec2& a, glm::dvec2& b) const;
};

// A range that holds all these values with a little room; a single value gets some around it. A
// logarithmic one takes no notice of what is not positive; none of what is not finite. Without any
// value: 0.1 to 1.
glm::dvec2 axis_range(const std::vector<double>& values, bool log);

}  // namespace lobe
