// SPDX-License-Identifier: Apache-2.0
#include "report/chart/interval_chart.h"

#include <algorithm>
#include <cmath>

#include "report/chart/frame.h"

namespace lobe {
namespace {

constexpr double plot_width = 360, row = 26, right = 110, top = 40, bottom = 46;

}  // namespace

Drawing draw(const IntervalChart& chart) {
    double left = 40;
    std::vector<double> values = {chart.neutral};
    for (const IntervalRow& r : chart.rows) {
        left = std::max(left, 24 + text_width(r.label, text_size));
        for (const double value : {r.low, r.value, r.high}) values.push_back(value);
    }
    left = std::min(left, 280.0);
    const glm::dvec2 range = axis_range(values, chart.log);
    ChartFrame frame;
    frame.x = {range.x, range.y, left, left + plot_width, chart.log};
    const double base = top + row * static_cast<double>(chart.rows.size()) + 6;
    frame.y = {1, 2, base, top, true};
    Drawing drawing;
    drawing.title = chart.title;
    drawing.width = left + plot_width + right;
    drawing.height = base + bottom;
    for (const double value : frame.x.ticks()) {
        const double x = frame.x.at(value);
        drawing.add(Polyline{{{x, top}, {x, base}}, grid_ink, 0.8});
        drawing.add(Text{{x, base + 16}, plot_number(value), note_ink, note_size, Anchor::middle});
    }
    const double neutral = frame.x.at(chart.neutral);
    drawing.add(Polyline{{{neutral, top}, {neutral, base}}, note_ink, 1.2});
    drawing.add(Text{{12, 18}, chart.title, text_ink, title_size});
    drawing.add(Text{
        {left + plot_width / 2, base + 34}, chart.x_label, note_ink, text_size, Anchor::middle});
    const Ink ink = series_ink(1, 4);
    for (std::size_t i = 0; i < chart.rows.size(); ++i) {
        const IntervalRow& r = chart.rows[i];
        const double y = top + row * (static_cast<double>(i) + 0.5) + 3;
        drawing.add(Text{{left - 8, y + 4},
                         fitted(r.label, text_size, left - 20),
                         text_ink,
                         text_size,
                         Anchor::end});
        drawing.add(Text{{left + plot_width + 10, y + 4},
                         fitted(r.verdict, text_size, right - 12),
                         note_ink,
                         text_size});
        if (!std::isfinite(r.value) || (chart.log && r.value <= 0)) continue;
        const auto at = [&](double value, double edge) {
            const bool shown = std::isfinite(value) && (value > 0 || !chart.log);
            return shown ? glm::clamp(frame.x.at(value), left, left + plot_width) : edge;
        };
        drawing.add(Polyline{{{at(r.low, left), y}, {at(r.high, left + plot_width), y}}, ink, 3});
        drawing.add(Dot{{frame.x.at(r.value), y}, 4.5, ink});
    }
    return drawing;
}

}  // namespace lobe
