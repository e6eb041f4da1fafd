// SPDX-License-Identifier: Apache-2.0
#include "lab/plot/plot_polar.h"

#include <algorithm>
#include <cmath>

#include "base/luminance.h"
#include "lab/measure/plane.h"
#include "report/chart/plot_style.h"

namespace lobe {
namespace {

constexpr double radius = 168, left = 42, right = 22, top = 74, bottom = 40, gap = 44;
constexpr std::size_t columns = 3;

class PolarPlot {
  public:
    PolarPlot(Drawing& drawing, const glm::dvec2& origin, const Axis& axis)
        : drawing_(drawing), origin_(origin), axis_(axis) {}

    void draw(const PolarPanel& panel) {
        drawing_.add(Text{{origin_.x - radius, origin_.y - radius - top + 32},
                          panel.title,
                          text_ink,
                          title_size});
        drawing_.add(Text{{origin_.x - radius, origin_.y - radius - top + 48},
                          fitted(panel.subtitle, note_size, 2 * radius),
                          note_ink,
                          note_size});
        grid();
        const std::size_t count = panel.curves.size();
        for (std::size_t i = 0; i < count; ++i) {
            const PolarCurve& curve = panel.curves[i];
            const Ink ink = series_ink(i, count);
            std::vector<glm::dvec2> points;
            for (const glm::dvec2& p : curve.points) points.push_back(at(p.x, radial(p.y)));
            drawing_.add(Polyline{points, ink, 1.6});
            viewer(curve.view, ink);
        }
    }

  private:
    // Angles of light are positive to the right.
    glm::dvec2 at(double angle, double r) const {
        return origin_ + r * glm::dvec2(std::sin(angle), -std::cos(angle));
    }
    double radial(double f) const { return axis_.at(glm::clamp(f, axis_.low, axis_.high)); }

    void grid() {
        for (const double value : axis_.ticks()) {
            const double r = axis_.at(value);
            if (r < 0.02 * radius) continue;
            std::vector<glm::dvec2> arc;
            for (int k = -90; k <= 90; k += 2) arc.push_back(at(glm::radians(double(k)), r));
            drawing_.add(Polyline{arc, grid_ink, 0.8});
            drawing_.add(Text{{origin_.x + r, origin_.y + 14},
                              plot_number(value),
                              note_ink,
                              note_size,
                              Anchor::middle});
        }
        for (const double angle : {-60, -30, 0, 30, 60})
            drawing_.add(Polyline{{origin_, at(glm::radians(angle), radius)}, grid_ink, 0.8});
        for (const double angle : {30, 60}) {
            const glm::dvec2 p = at(glm::radians(angle), radius + 7);
            drawing_.add(Text{{p.x, p.y + 3}, plot_number(angle) + "°", note_ink, note_size});
        }
        drawing_.add(Polyline{
            {origin_ - glm::dvec2(radius, 0), origin_ + glm::dvec2(radius, 0)}, axis_ink, 0.8});
        drawing_.add(Text{{origin_.x, origin_.y + 14},
                          axis_.log ? plot_number(axis_.low) : "0",
                          note_ink,
                          note_size,
                          Anchor::middle});
        drawing_.add(Text{
            {origin_.x + radius, origin_.y + 30}, "f in 1/sr", note_ink, note_size, Anchor::end});
        drawing_.add(Text{
            {origin_.x - radius, origin_.y + 30}, "dots: angles of view", note_ink, note_size});
    }

    // Where the viewer stands, on the left.
    void viewer(double view, const Ink& ink) {
        drawing_.add(Dot{at(-view, radius), 3.2, ink});
        const glm::dvec2 p = at(-view, radius + 9);
        const Anchor anchor = view < 0.1 ? Anchor::middle : Anchor::end;
        drawing_.add(Text{{p.x, p.y + (view < 0.1 ? 1 : 3)},
                          plot_number(glm::degrees(view)) + "°",
                          ink,
                          text_size,
                          anchor});
    }

    Drawing& drawing_;
    glm::dvec2 origin_;
    Axis axis_;
};

Axis radial_axis(const PolarPanel& panel, Scale scale) {
    if (!(panel.top > 0)) return {0, 1, 0, radius, false};
    const bool peaked = panel.top > 25 * panel.typical;
    if (scale == Scale::linear || (scale == Scale::automatic && !peaked))
        return {0, panel.top, 0, radius, false};
    const double high = std::pow(10.0, std::ceil(std::log10(panel.top) - 0.05));
    const double least = std::max(panel.typical, 1e-6 * high);
    return {std::pow(10.0, std::floor(std::log10(least) - 0.5)), high, 0, radius, true};
}

// Each panel's own, or one for all where they are of a kind and much the same.
std::vector<Axis> radial_axes(const std::vector<PolarPanel>& panels, Scale scale) {
    std::vector<Axis> axes;
    for (const PolarPanel& panel : panels) axes.push_back(radial_axis(panel, scale));
    Axis all = axes[0];
    double smallest = all.high;
    for (const Axis& axis : axes) {
        if (axis.log != all.log) return axes;
        all.low = std::min(all.low, axis.low);
        all.high = std::max(all.high, axis.high);
        smallest = std::min(smallest, axis.high);
    }
    if (all.high <= (all.log ? 100 : 4) * smallest) std::fill(axes.begin(), axes.end(), all);
    return axes;
}

}  // namespace

PolarPanel polar_panel(BrdfProbe& probe, const Subject& subject, const std::vector<double>& views,
                       double azimuth) {
    probe.set_parameters({subject.rows}, subject.tables);
    const Plane plane(probe, azimuth);
    PolarPanel panel{subject.model.name, subject.text(), {}, 0, 0};
    const double last = glm::radians(89.0);  // beyond, values of many a model go to infinity
    std::vector<PlaneView> seen;
    std::vector<double> all;
    for (const double degrees : views) {
        seen.push_back({0, glm::radians(degrees)});
        panel.curves.push_back({seen.back().view, {}});
        std::vector<PlanePoint> points;
        for (const double angle : Plane::angles(seen.back().view))
            if (std::abs(angle) <= std::max(last, seen.back().view))
                points.push_back({seen.back(), angle});
        const std::vector<double> f = plane.luminances(points);
        for (std::size_t i = 0; i < f.size(); ++i)
            panel.curves.back().points.push_back({points[i].light, f[i]});
        std::vector<PlanePoint> even;
        for (int k = -88; k <= 88; k += 2) even.push_back({seen.back(), glm::radians(double(k))});
        const std::vector<double> values = plane.luminances(even);
        all.insert(all.end(), values.begin(), values.end());
    }
    for (const PlaneLobe& lobe : plane.lobes(seen)) panel.top = std::max(panel.top, lobe.peak);
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2),
                     all.end());
    panel.typical = all[all.size() / 2];
    return panel;
}

Drawing draw_polar(const std::vector<PolarPanel>& panels, Scale scale) {
    const std::vector<Axis> axes = radial_axes(panels, scale);
    const std::size_t across = std::min(columns, panels.size());
    const std::size_t down = (panels.size() + columns - 1) / columns;
    const double width = 2 * radius + gap, height = top + radius + bottom;
    Drawing drawing;
    drawing.title = "Reflectance in the plane of incidence";
    drawing.width = left + static_cast<double>(across) * width - gap + right;
    drawing.height = static_cast<double>(down) * height;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const glm::dvec2 origin(left + radius + static_cast<double>(i % columns) * width,
                                top + radius + static_cast<double>(i / columns) * height);
        PolarPlot(drawing, origin, axes[i]).draw(panels[i]);
    }
    return drawing;
}

}  // namespace lobe
