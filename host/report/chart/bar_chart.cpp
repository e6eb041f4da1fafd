// SPDX-License-Identifier: Apache-2.0
#include "report/chart/bar_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "report/chart/frame.h"

namespace lobe {
namespace {

constexpr double plot_width = 440, row = 30, thick = 18, right = 76, legend_row = 18, bottom = 46;

double part_of(const Bar& bar, std::size_t part) {
    if (part >= bar.values.size()) return 0;
    const double value = bar.values[part];
    return std::isfinite(value) ? std::max(value, 0.0) : 0;
}

double sum_of(const BarChart& chart, const Bar& bar) {
    double sum = 0;
    for (std::size_t part = 0; part < chart.parts.size(); ++part) sum += part_of(bar, part);
    return sum;
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return plot_number(std::atof(text));
}

Area rectangle(const glm::dvec2& low, const glm::dvec2& high, const Ink& ink) {
    return {{low, {high.x, low.y}, high, {low.x, high.y}}, ink};
}

// Squares with names in lines below the title; the height they take.
double add_legend(Drawing& drawing, const BarChart& chart, double width) {
    double x = 12, y = 42;
    for (std::size_t part = 0; part < chart.parts.size(); ++part) {
        const double wide = 34 + text_width(chart.parts[part], text_size);
        if (x + wide > width && x > 12) {
            x = 12;
            y += legend_row;
        }
        drawing.add(rectangle({x, y - 9}, {x + 10, y + 1}, series_ink(part, chart.parts.size())));
        drawing.add(Text{{x + 15, y}, chart.parts[part], note_ink, text_size});
        x += wide;
    }
    return y;
}

}  // namespace

Drawing draw(const BarChart& chart) {
    double left = 40, most = 0;
    for (const Bar& bar : chart.bars) {
        left = std::max(left, 24 + text_width(bar.label, text_size));
        most = std::max(most, sum_of(chart, bar));
    }
    left = std::min(left, 260.0);
    Drawing drawing;
    drawing.title = chart.title;
    drawing.width = left + plot_width + right;
    const double top = add_legend(drawing, chart, drawing.width) + 16;
    const double base = top + row * static_cast<double>(chart.bars.size()) + 4;
    drawing.height = base + bottom;

    const Axis x{0, most > 0 ? 1.02 * most : 1, left, left + plot_width};
    for (const double value : x.ticks()) {
        drawing.add(Polyline{{{x.at(value), top}, {x.at(value), base}}, grid_ink, 0.8});
        drawing.add(Text{
            {x.at(value), base + 16}, plot_number(value), note_ink, note_size, Anchor::middle});
    }
    drawing.add(Polyline{{{left, top}, {left, base}}, axis_ink, 1});
    drawing.add(Text{{12, 18}, chart.title, text_ink, title_size});
    drawing.add(Text{
        {left + plot_width / 2, base + 34}, chart.x_label, note_ink, text_size, Anchor::middle});
    for (std::size_t i = 0; i < chart.bars.size(); ++i) {
        const Bar& bar = chart.bars[i];
        const double y = top + row * static_cast<double>(i) + (row - thick) / 2;
        drawing.add(Text{{left - 8, y + thick / 2 + 4},
                         fitted(bar.label, text_size, left - 20),
                         text_ink,
                         text_size,
                         Anchor::end});
        double sum = 0;
        for (std::size_t part = 0; part < chart.parts.size(); ++part) {
            const double value = part_of(bar, part);
            if (value > 0)
                drawing.add(rectangle({x.at(sum), y}, {x.at(sum + value), y + thick},
                                      series_ink(part, chart.parts.size())));
            sum += value;
        }
        drawing.add(
            Text{{x.at(sum) + 7, y + thick / 2 + 4}, short_number(sum), note_ink, text_size});
    }
    return drawing;
}

}  // namespace lobe
