// SPDX-License-Identifier: Apache-2.0
#include "report/chart/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lobe {

void ChartFrame::draw(Drawing& drawing, const std::string& title, const std::string& x_label,
                      const std::string& y_label) const {
    for (const double value : y.ticks()) {
        const double at = y.at(value);
        drawing.add(Polyline{{{x.from, at}, {x.to, at}}, grid_ink, 0.8});
        drawing.add(
            Text{{x.from - 8, at + 4}, plot_number(value), note_ink, note_size, Anchor::end});
    }
    for (const double value : x.ticks()) {
        const double at = x.at(value);
        drawing.add(Polyline{{{at, y.from}, {at, y.to}}, grid_ink, 0.8});
        drawing.add(
            Text{{at, y.from + 16}, plot_number(value), note_ink, note_size, Anchor::middle});
    }
    drawing.add(Polyline{{{x.from, y.from}, {x.to, y.from}}, axis_ink, 1});
    const double middle = 0.5 * (x.from + x.to);
    drawing.add(Text{{middle, y.from + 34}, x_label, note_ink, text_size, Anchor::middle});
    drawing.add(Text{{12, y.to - 12}, y_label, note_ink, text_size});
    drawing.add(Text{{12, 18}, title, text_ink, title_size});
}

bool ChartFrame::clip(glm::dvec2& a, glm::dvec2& b) const {
    const glm::dvec2 low = glm::min(glm::dvec2(x.from, y.from), glm::dvec2(x.to, y.to));
    const glm::dvec2 high = glm::max(glm::dvec2(x.from, y.from), glm::dvec2(x.to, y.to));
    const glm::dvec2 start = a, along = b - a;
    double enter = 0, leave = 1;
    for (int i = 0; i < 2; ++i) {
        if (along[i] == 0) {
            if (start[i] < low[i] || start[i] > high[i]) return false;
            continue;
        }
        double first = (low[i] - start[i]) / along[i], last = (high[i] - start[i]) / along[i];
        if (first > last) std::swap(first, last);
        enter = std::max(enter, first);
        leave = std::min(leave, last);
    }
    a = start + enter * along;
    b = start + leave * along;
    return enter < leave;
}

glm::dvec2 axis_range(const std::vector<double>& values, bool log) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : values) {
        if (!std::isfinite(value) || (log && value <= 0)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (low > high) return {0.1, 1};
    if (log) {
        const double room = std::max(std::pow(high / low, 0.04), low == high ? 2.0 : 1.05);
        return {low / room, high * room};
    }
    const double room = low < high ? 0.04 * (high - low) : std::max(std::abs(low), 1.0) / 2;
    return {low >= 0 ? std::max(0.0, low - room) : low - room, high + room};
}

}  // namespace lobe
