// SPDX-License-Identifier: Apache-2.0
#include "lab/plot/plot_curves.h"

#include <algorithm>

#include "lab/parameter_sweep.h"
#include "lab/measure/plane.h"
#include "report/chart/plot_style.h"

namespace lobe {
namespace {

constexpr double panel_width = 340, panel_height = 240, left = 44, right = 16, top = 68,
                 bottom = 46, gap = 28;
constexpr std::size_t columns = 3;

// The lobes of the probe's first `sets` parameter sets, in degrees and parts of their peaks.
std::vector<std::vector<glm::dvec2>> lobes_of(const BrdfProbe& probe, std::uint32_t sets) {
    const Plane plane(probe);
    std::vector<PlaneView> views;
    std::vector<PlanePoint> points;
    for (std::uint32_t set = 0; set < sets; ++set) views.push_back({set, 0});
    for (const PlaneView& view : views)
        for (const double angle : Plane::angles(0))
            if (angle >= 0) points.push_back({view, angle});
    const std::vector<PlaneLobe> lobes = plane.lobes(views);
    const std::vector<double> f = plane.luminances(points);
    std::vector<std::vector<glm::dvec2>> out(sets);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PlaneLobe& lobe = lobes[points[i].from.set];
        const double rise = lobe.any ? lobe.peak - lobe.base : lobe.peak;
        const double g = rise > 0 ? (f[i] - (lobe.any ? lobe.base : 0)) / rise : 0;
        out[points[i].from.set].push_back({glm::degrees(points[i].light), g});
    }
    return out;
}

class LobePlot {
  public:
    // `corner`: of the axes, above left.
    LobePlot(Drawing& drawing, const glm::dvec2& corner, bool log) : drawing_(drawing) {
        x_ = {0, 90, corner.x, corner.x + panel_width};
        y_ = {log ? 1e-5 : 0, 1, corner.y + panel_height, corner.y, log};
    }

    void draw(const LobePanel& panel, bool first) {
        axes(first);
        drawing_.add(Text{{x_.from, y_.to - 44}, panel.title, text_ink, title_size});
        drawing_.add(Text{{x_.from, y_.to - 28},
                          fitted(panel.subtitle, note_size, panel_width),
                          note_ink,
                          note_size});
        std::vector<Curve> curves;
        for (std::size_t i = 0; i < panel.curves.size(); ++i) {
            Curve curve{{}, series_ink(i, panel.curves.size()), panel.curves[i].label};
            for (const glm::dvec2& p : panel.curves[i].points) {
                if (p.y < y_.low) break;  // what may rise again is not the lobe
                curve.points.push_back({x_.at(p.x), y_.at(std::min(p.y, y_.high))});
            }
            drawing_.add(Polyline{curve.points, curve.ink, 1.6});
            curves.push_back(curve);
        }
        add_labels(drawing_, curves, {x_.from + 2, y_.to + 2}, {x_.to, y_.from - 2});
    }

  private:
    void axes(bool first) {
        if (first)
            drawing_.add(Text{
                {x_.from - 36, y_.to - 10}, "(f - least) / (peak - least)", note_ink, note_size});
        for (const double value : y_.ticks()) {
            const double y = y_.at(value);
            drawing_.add(Polyline{{{x_.from, y}, {x_.to, y}}, grid_ink, 0.8});
            if (first)
                drawing_.add(Text{
                    {x_.from - 6, y + 4}, plot_number(value), note_ink, note_size, Anchor::end});
        }
        for (const double degrees : {0, 15, 30, 45, 60, 75, 90}) {
            const double x = x_.at(degrees);
            drawing_.add(Polyline{{{x, y_.from}, {x, y_.from + 4}}, axis_ink, 0.8});
            drawing_.add(Text{{x, y_.from + 16},
                              plot_number(degrees) + "°",
                              note_ink,
                              note_size,
                              Anchor::middle});
        }
        drawing_.add(Polyline{{{x_.from, y_.from}, {x_.to, y_.from}}, axis_ink, 0.8});
        drawing_.add(Text{{0.5 * (x_.from + x_.to), y_.from + 34},
                          "angle to the mirror direction",
                          note_ink,
                          note_size,
                          Anchor::middle});
    }

    Drawing& drawing_;
    Axis x_{}, y_{};
};

}  // namespace

LobePanel lobe_panel(const Sharpened& model, const std::vector<double>& values) {
    LobePanel panel{
        model.subject.model.name, "by " + model.name() + "; " + model.subject.text(), {}};
    model.set(values);
    const auto lobes = lobes_of(model.probe, static_cast<std::uint32_t>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
        panel.curves.push_back({plot_number(values[i]), lobes[i]});
    return panel;
}

LobePanel lobe_panel(BrdfProbe& probe, const Subject& subject) {
    probe.set_parameters({subject.rows}, subject.tables);
    return {subject.model.name, subject.text(), {{"", lobes_of(probe, 1)[0]}}};
}

Drawing draw_lobes(const std::vector<LobePanel>& panels, bool log) {
    Drawing drawing;
    drawing.title = "Lobes over their peaks, at normal incidence";
    const std::size_t across = std::min(columns, panels.size());
    const std::size_t down = (panels.size() + columns - 1) / columns;
    const double width = panel_width + gap, height = top + panel_height + bottom;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const glm::dvec2 corner(left + width * static_cast<double>(i % columns),
                                top + height * static_cast<double>(i / columns));
        LobePlot(drawing, corner, log).draw(panels[i], i % columns == 0);
    }
    drawing.width = left + width * static_cast<double>(across) - gap + right;
    drawing.height = height * static_cast<double>(down);
    return drawing;
}

}  // namespace lobe
