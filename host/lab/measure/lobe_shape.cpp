// SPDX-License-Identifier: Apache-2.0
#include "lab/measure/lobe_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "base/luminance.h"
#include "lab/measure/plane.h"

namespace lobe {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = glm::pi<double>();

// Gauss and Legendre's rule of four points on [0, 1].
constexpr double node[] = {0.069431844202973712, 0.330009478207571868, 0.669990521792428132,
                           0.930568155797026288};
constexpr double weight[] = {0.173927422568726929, 0.326072577431273071, 0.326072577431273071,
                             0.173927422568726929};

double square(double x) { return x * x; }
// 1 - cos of an angle, with all its digits.
double versine(double angle) { return 2 * square(std::sin(0.5 * angle)); }

// -g'' at the peak. (1 - g) / (1 - cos) at an angle where g is 0.84, and at those with 1/2, 1/4 and
// 1/8 of its 1 - cos, extrapolated to 0 by Neville's scheme.
constexpr double shoulder = 0.84;
constexpr int levels = 4;

double angle_of_versine(double v) { return 2 * std::asin(std::sqrt(0.5 * v)); }

std::vector<double> curvatures(const Plane& plane, const std::vector<PlaneView>& views,
                               const std::vector<PlaneLobe>& lobes) {
    const auto shoulders = plane.fallen_to(shoulder, 1, views, lobes);
    std::vector<PlanePoint> points;
    for (std::size_t i = 0; i < views.size(); ++i)
        for (int k = 0; k < levels; ++k)
            points.push_back(
                {views[i], angle_of_versine(std::ldexp(versine(shoulders[i].value_or(0.1)), -k))});
    const std::vector<double> f = plane.luminances(points);
    std::vector<double> out;
    for (std::size_t i = 0; i < views.size(); ++i) {
        double slope[levels];
        for (int k = 0; k < levels; ++k) {
            const std::size_t at = i * levels + static_cast<std::size_t>(k);
            const double fall = (lobes[i].peak - f[at]) / (lobes[i].peak - lobes[i].base);
            slope[k] = fall / versine(points[at].light);
        }
        for (int order = 1; order < levels; ++order)
            for (int k = levels - 1; k >= order; --k)
                slope[k] += (slope[k] - slope[k - 1]) / (std::ldexp(1.0, order) - 1);
        out.push_back(shoulders[i] ? slope[levels - 1] : none);
    }
    return out;
}

// Angles from the normal: four within each panel, and its upper edge. Panels grow by 2^(1/8).
struct Profile {
    std::vector<double> edges = {0};

    explicit Profile(double half_width) {
        const double end = glm::half_pi<double>();
        const double first = glm::clamp(half_width / 16, 1e-9, 0.1);
        for (double edge = first; edge < 0.9 * end; edge *= 1.090507733) edges.push_back(edge);
        edges.push_back(end);
    }
    std::size_t panels() const { return edges.size() - 1; }
    double width(std::size_t panel) const { return edges[panel + 1] - edges[panel]; }
    double angle(std::size_t panel, int k) const {
        return k < 4 ? edges[panel] + node[k] * width(panel) : edges[panel + 1];
    }
    std::size_t size() const { return 5 * panels(); }
};

// A lobe that is not the same all round is averaged over so many azimuths.
constexpr int turns = 96;

// Whether any lobe of these depends on the azimuth.
bool turns_matter(const BrdfProbe& probe, const std::vector<PlaneLobe>& lobes) {
    BrdfQuery query;
    for (std::uint32_t set = 0; set < lobes.size(); ++set)
        for (const double part : {0.5, 1.0, 2.0})
            for (int k = 0; k < 8; ++k) {
                const double angle = std::min(part * lobes[set].above.value_or(0.5), 1.5);
                query.add(set, {0, 0, 1}, Plane(probe, k * pi / 8).light(angle));
            }
    const std::vector<BrdfValue> values = probe.eval(query);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double first = luminance(values[i / 8 * 8].f), here = luminance(values[i].f);
        if (std::abs(here - first) > 1e-3 * first) return true;
    }
    return false;
}

// g of each set at the angles of its profile.
std::vector<std::vector<double>> measure(const BrdfProbe& probe,
                                         const std::vector<PlaneLobe>& lobes,
                                         const std::vector<Profile>& profiles) {
    const int count = turns_matter(probe, lobes) ? turns : 1;
    std::vector<std::vector<double>> means;
    for (const Profile& profile : profiles) means.emplace_back(profile.size(), 0);
    for (int turn = 0; turn < count; ++turn) {
        const Plane plane(probe, 2 * pi * turn / count);
        std::vector<PlanePoint> points;
        for (std::uint32_t set = 0; set < lobes.size(); ++set)
            for (std::size_t i = 0; i < profiles[set].size(); ++i)
                points.push_back({{set, 0}, profiles[set].angle(i / 5, static_cast<int>(i % 5))});
        const std::vector<double> f = plane.luminances(points);
        std::size_t place = 0;
        for (std::size_t set = 0; set < lobes.size(); ++set)
            for (double& g : means[set])
                g += (f[place++] - lobes[set].base) / (lobes[set].peak - lobes[set].base) / count;
    }
    return means;
}

// The angle at which the integral, known at the panels' edges with its derivative, is half.
double median_angle(const Profile& profile, const std::vector<double>& sums,
                    const std::vector<double>& g) {
    const double half = 0.5 * sums.back();
    std::size_t panel = 0;
    while (panel + 1 < profile.panels() && sums[panel + 1] < half) ++panel;
    const auto slope = [&](std::size_t edge) {
        return edge ? 2 * pi * g[5 * edge - 1] * std::sin(profile.edges[edge]) : 0;
    };
    const double h = profile.width(panel);
    const double low = sums[panel], high = sums[panel + 1];
    const double slope_low = h * slope(panel), slope_high = h * slope(panel + 1);
    double from = 0, to = 1;
    for (int k = 0; k < 50; ++k) {
        const double t = 0.5 * (from + to), s = 1 - t;
        const double sum = s * s * (1 + 2 * t) * low + t * t * (3 - 2 * t) * high +
                           t * s * (s * slope_low - t * slope_high);
        (sum < half ? from : to) = t;
    }
    return profile.edges[panel] + from * h;
}

void integrate_profile(const Profile& profile, const std::vector<double>& g, LobeShape& shape) {
    std::vector<double> sums = {0};
    shape.albedo = 0;
    for (std::size_t panel = 0; panel < profile.panels(); ++panel) {
        double sum = 0;
        for (int k = 0; k < 4; ++k) {
            const double angle = profile.angle(panel, k);
            const double part = 2 * pi * weight[k] * profile.width(panel) * std::sin(angle) *
                                g[5 * panel + static_cast<std::size_t>(k)];
            sum += part;
            shape.albedo += part * std::cos(angle);
        }
        sums.push_back(sums.back() + sum);
    }
    shape.integral = sums.back();
    shape.median = median_angle(profile, sums, g);
}

}  // namespace

std::vector<LobeShape> measure_lobe_shapes(const BrdfProbe& probe, std::uint32_t sets) {
    const Plane plane(probe);
    std::vector<PlaneView> views;
    for (std::uint32_t set = 0; set < sets; ++set) views.push_back({set, 0});
    const std::vector<PlaneLobe> lobes = plane.lobes(views);
    const std::vector<double> curvature = curvatures(plane, views, lobes);
    std::vector<Profile> profiles;
    for (const PlaneLobe& lobe : lobes) profiles.emplace_back(lobe.above.value_or(1));
    const std::vector<std::vector<double>> g = measure(probe, lobes, profiles);
    std::vector<LobeShape> shapes;
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        LobeShape shape{
            lobes[i].peak, lobes[i].base, curvature[i], lobes[i].above.value_or(none), 0, 0, 0};
        integrate_profile(profiles[i], g[i], shape);
        const bool at_normal = std::abs(lobes[i].at) < 0.05 * lobes[i].above.value_or(1);
        if (!lobes[i].any || !at_normal)
            shape.curvature = shape.half_width = shape.integral = shape.albedo = shape.median =
                none;
        shapes.push_back(shape);
    }
    return shapes;
}

}  // namespace lobe
