// SPDX-License-Identifier: Apache-2.0
#include "report/chart/line_chart.h"

#include <algorithm>
#include <cmath>

#include "report/chart/frame.h"

namespace lobe {
namespace {

constexpr double left = 64, top = 64, plot_width = 560, plot_height = 330, right = 150, bottom = 46;

struct Label {
    std::string text;
    Ink ink;
    glm::dvec2 end;  // of its curve
    double y;        // where it stands
};

// For text, which is thinner than a line.
Ink darker(const Ink& ink) {
    const auto half = [](int a, int b) { return static_cast<std::uint8_t>((a + b) / 2); };
    return {half(ink.red, text_ink.red), half(ink.green, text_ink.green),
            half(ink.blue, text_ink.blue)};
}

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
        add_end_labels();
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
        Polyline part{{}, ink, 1.8};
        std::optional<glm::dvec2> last;
        Area band{{}, ink, 0.16};
        std::vector<glm::dvec2> lower;
        const auto end_part = [&] {
            band.points.insert(band.points.end(), lower.rbegin(), lower.rend());
            if (band.points.size() >= 4) drawing_.add(band);
            if (part.points.size() >= 2) drawing_.add(part);
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
            last = p;
            part.points.push_back(p);
            drawing_.add(Dot{p, 2.6, ink});
            if (i >= series.band.size()) continue;
            band.points.push_back({p.x, band_at(series.band[i].y)});
            lower.push_back({p.x, band_at(series.band[i].x)});
        }
        if (last) labels_.push_back({series.label, darker(ink), *last, 0});
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
        labels_.push_back({label, note_ink, b, 0});
    }

    // Each at the right end of its curve, or as near as the others leave room.
    void add_end_labels() {
        constexpr double apart = 14;
        std::sort(labels_.begin(), labels_.end(),
                  [](const Label& a, const Label& b) { return a.end.y < b.end.y; });
        double free = top + 4;
        for (Label& label : labels_) {
            label.y = std::max(label.end.y, free);
            free = label.y + apart;
        }
        double below = top + plot_height;
        for (auto label = labels_.rbegin(); label != labels_.rend(); ++label) {
            label->y = std::min(label->y, below);
            below = label->y - apart;
        }
        for (const Label& label : labels_) {
            const double x = left + plot_width + 10;
            drawing_.add(Text{
                {x, label.y + 4}, fitted(label.text, text_size, right - 12), label.ink, text_size});
        }
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
    std::vector<Label> labels_;
};

}  // namespace

Drawing draw(const LineChart& chart) { return Plot(chart).draw(); }

}  // namespace lobe
