// SPDX-License-Identifier: Apache-2.0
#include "report/chart/histogram.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "report/chart/frame.h"

namespace lobe {
namespace {

constexpr double left = 64, top = 64, plot_width = 440, plot_height = 200, right = 28, bottom = 46;

}  // namespace

std::vector<std::size_t> counts(const Histogram& h) {
    std::vector<std::size_t> out(h.bins);
    for (const double value : h.values) {
        if (!(value >= h.low && value <= h.high)) continue;
        const double part = (value - h.low) / (h.high - h.low) * static_cast<double>(h.bins);
        ++out[std::min(static_cast<std::size_t>(part), h.bins - 1)];
    }
    return out;
}

Drawing draw(const Histogram& h) {
    const std::vector<std::size_t> heights = counts(h);
    double all = 0, most = 1;
    for (const std::size_t n : heights) {
        all += static_cast<double>(n);
        most = std::max(most, static_cast<double>(n));
    }
    const double p = 1 / static_cast<double>(h.bins), expected = all * p;
    const double half = normal_quantile(0.975) * std::sqrt(all * p * (1 - p));
    if (h.uniform_band) most = std::max(most, expected + half);

    ChartFrame frame;
    frame.x = {h.low, h.high, left, left + plot_width};
    frame.y = {0, 1.05 * most, top + plot_height, top};
    Drawing drawing;
    drawing.title = h.title;
    drawing.width = left + plot_width + right;
    drawing.height = top + plot_height + bottom;
    const Ink ink = series_ink(1, 4);
    const double wide = plot_width * p;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (heights[i] == 0) continue;
        const double x = left + wide * static_cast<double>(i), base = frame.y.from,
                     y = frame.y.at(static_cast<double>(heights[i]));
        drawing.add(
            Area{{{x + 0.75, base}, {x + 0.75, y}, {x + wide - 0.75, y}, {x + wide - 0.75, base}},
                 ink,
                 0.8});
    }
    frame.draw(drawing, h.title, h.x_label, "count");
    if (h.uniform_band && all > 0) {
        const double low = frame.y.at(std::max(0.0, expected - half)),
                     high = frame.y.at(expected + half), at = frame.y.at(expected),
                     end = left + plot_width;
        drawing.add(Area{{{left, low}, {end, low}, {end, high}, {left, high}}, axis_ink, 0.3});
        drawing.add(Polyline{{{left, at}, {end, at}}, note_ink, 1});
    }
    return drawing;
}

}  // namespace lobe
