// SPDX-License-Identifier: Apache-2.0
#include "report/chart/line_chart.h"

#include <algorithm>
#include <cmath>

#include "report/chart/frame.h"

namespace lobe {
namespace {

constexpr double left = 64, top = 64, plot_width = 560, plot_height = 330, right = 28, bottom = 46;

class Plot {
  public:
    explicit Plot(const LineChart& chart) : chart_(chart) {
        std::vector<double> xs, ys;
        for (const ChartSeries& series : chart.series)
            for (std::size_t i = 0; i < series.points.size(); ++i) {
                if (!shown(series.points[i])) continue;
                xs.push_back(series.points[i].x);
                ys.push_back(series.points[i].y);
                if (i < series.band.size()) ys.push_back(series.band[i].y);
                // A band down to nothing would be most of a logarithmic axis.
                if (i < series.band.size())
                    ys.push_back(chart.log_y ? std::max(series.band[i].x, series.points[i].y / 10)
                                             : series.band[i].x);
            }
        if (chart.level) ys.push_back(*chart.level);
        const glm::dvec2 x = axis_range(xs, chart.log_x), y = axis_range(ys, chart.log_y);
        frame_.x = {x.x, x.y, left, left + plot_width, chart.log_x};
        frame_.y = {y.x, y.y, top + plot_height, top, chart.log_y};
    }

    Drawing draw() {
        drawing_.width = left + plot_width + right;
        drawing_.height = top + plot_height + bottom;
        drawing_.title = chart_.title;
        frame_.draw(drawing_, chart_.title, chart_.x_label, chart_.y_label);
        add_level();
        add_guide();
        for (std::size_t i = 0; i < chart_.series.size(); ++i)
            add_series(chart_.series[i], series_ink(i, chart_.series.size()));
        add_labels(drawing_, curves_, {left + 2, top + 2}, {left + plot_width, top + plot_height});
        return drawing_;
    }

  private:
    bool shown(const glm::dvec2& p) const {
        return std::isfinite(p.x) && std::isfinite(p.y) && (p.x > 0 || !chart_.log_x) &&
               (p.y > 0 || !chart_.log_y);
    }

    glm::dvec2 at(const glm::dvec2& p) const { return {frame_.x.at(p.x), frame_.y.at(p.y)}; }

    // Where an end of a band stands; what the axis cannot show, at its lower edge.
    double band_at(double value) const {
        if (!(value > frame_.y.low)) return frame_.y.from;
        return frame_.y.at(std::min(value, frame_.y.high));
    }

    void add_series(const ChartSeries& series, const Ink& ink) {
        Curve part{{}, ink, series.label};
        Area band{{}, ink, 0.16};
        std::vector<glm::dvec2> lower;
        const auto end_part = [&] {
            band.points.insert(band.points.end(), lower.rbegin(), lower.rend());
            if (band.points.size() >= 4) drawing_.add(band);
            if (part.points.size() >= 2) drawing_.add(Polyline{part.points, ink, 1.8});
            if (!part.points.empty()) curves_.push_back(part);
            if (!part.points.empty()) part.label.clear();  // once a series
            part.points.clear();
            band.points.clear();
            lower.clear();
        };
        for (std::size_t i = 0; i < series.points.size(); ++i) {
            if (!shown(series.points[i])) {
                end_part();
                continue;
            }
            const glm::dvec2 p = at(series.points[i]);
            part.points.push_back(p);
            drawing_.add(Dot{p, 2.6, ink});
            if (i >= series.band.size()) continue;
            band.points.push_back({p.x, band_at(series.band[i].y)});
            lower.push_back({p.x, band_at(series.band[i].x)});
        }
        end_part();
    }

    // A straight line cut to the frame, in dashes, with its name.
    void add_dashed(glm::dvec2 a, glm::dvec2 b, const std::string& label) {
        if (!frame_.clip(a, b)) return;
        const double length = glm::distance(a, b), dash = 5, gap = 4;
        for (double s = 0; s < length; s += dash + gap)
            drawing_.add(Polyline{
                {a + s / length * (b - a), a + std::min(s + dash, length) / length * (b - a)},
                axis_ink,
                1.2});
        curves_.push_back({{a, b}, note_ink, label});
    }

    void add_level() {
        if (!chart_.level || (chart_.log_y && *chart_.level <= 0)) return;
        const double y = frame_.y.at(*chart_.level);
        add_dashed({left, y}, {left + plot_width, y}, plot_number(*chart_.level));
    }

    // Through the geometric mean of the curves' first points, some way below it: there it crosses
    // few curves.
    void add_guide() {
        if (!chart_.guide_slope || !chart_.log_x || !chart_.log_y) return;
        glm::dvec2 sum(0);
        double count = 0;
        for (const ChartSeries& series : chart_.series) {
            const auto first = std::find_if(series.points.begin(), series.points.end(),
                                            [&](const glm::dvec2& p) { return shown(p); });
            if (first == series.points.end()) continue;
            sum += glm::log(*first);
            count += 1;
        }
        if (count == 0) return;
        const glm::dvec2 through = sum / count - glm::dvec2(0, std::log(1.6));
        const auto point = [&](double x) {
            const double y = through.y + *chart_.guide_slope * (std::log(x) - through.x);
            return at({x, std::exp(y)});
        };
        const bool half = *chart_.guide_slope == -0.5;
        add_dashed(point(frame_.x.low), point(frame_.x.high),
                   half ? "slope −1/2" : "slope " + plot_number(*chart_.guide_slope));
    }

    const LineChart& chart_;
    ChartFrame frame_;
    Drawing drawing_;
    std::vector<Curve> curves_;
};

}  // namespace

Drawing draw(const LineChart& chart) { return Plot(chart).draw(); }

}  // namespace lobe
