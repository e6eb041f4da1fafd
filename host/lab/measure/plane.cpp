// SPDX-License-Identifier: Apache-2.0
#include "lab/measure/plane.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/luminance.h"
#include "base/random.h"
#include "lab/hemisphere.h"

namespace lobe {

const double grazing = glm::half_pi<double>() - 1e-7;

namespace {

// Evaluations that narrow a bracket: each round cuts it into so many pieces.
constexpr int pieces = 16, rounds = 5;
// Rounding may lift a value so far over one that is as large; and a rise below this part of the
// peak is none.
constexpr double rounding = 3e-6;

double clamped(double angle) { return glm::clamp(angle, -grazing, grazing); }

struct Bracket {
    double low, high;
    double at(int piece) const { return low + (high - low) * piece / pieces; }
};

std::vector<PlanePoint> inside(const std::vector<PlaneView>& views,
                               const std::vector<Bracket>& brackets) {
    std::vector<PlanePoint> points;
    for (std::size_t i = 0; i < views.size(); ++i)
        for (int k = 0; k <= pieces; ++k) points.push_back({views[i], brackets[i].at(k)});
    return points;
}

// Sorted, above the horizon, each once.
void tidy(std::vector<double>& angles) {
    for (double& a : angles) a = clamped(a) + 0.0;  // no -0
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
}

// Distances from a centre at which a lobe of any sharpness shows, up to pi.
std::vector<double> distances() {
    std::vector<double> all;
    for (int k = 0; k < 124; ++k) all.push_back(1e-9 * std::pow(10.0, k / 13.0));
    for (int k = 1; k <= 360; ++k) all.push_back(glm::radians(0.5 * k));
    std::sort(all.begin(), all.end());
    return all;
}

// Peaks are sought up to here: beyond, the values of many a model go to infinity.
double last_peak(double view) { return std::max(view, glm::radians(89.0)); }

// What a first look at the values of one view, sorted by their angles, shows.
PlaneLobe first_look(const std::vector<double>& angles, const double* values, double view) {
    const auto place_of = [&](double angle) {
        return std::lower_bound(angles.begin(), angles.end(), clamped(angle)) - angles.begin();
    };
    const double* const least = std::min_element(values, values + angles.size());
    const double* const most = std::max_element(values + place_of(-last_peak(view)),
                                                values + place_of(last_peak(view)) + 1);
    PlaneLobe lobe;
    auto peak = static_cast<std::size_t>(most - values);
    // Of values that are alike but for rounding, the one at a direction that means something.
    for (const double centre : {-view, 0.0, view}) {
        const auto place = static_cast<std::size_t>(place_of(centre));
        if (values[place] >= *most * (1 - rounding)) peak = place;
    }
    lobe.base = *least;
    lobe.peak = values[peak];
    lobe.at = angles[peak];
    lobe.any = std::isfinite(*most) && *most - *least > rounding * *most;
    return lobe;
}

}  // namespace

std::optional<double> PlaneLobe::half_width() const {
    if (below && above) return 0.5 * (*below + *above);
    return below ? below : above;
}

glm::dvec3 Plane::viewer(double angle) const {
    const double r = std::sin(angle), z = std::cos(angle);
    return {r * std::cos(azimuth_), r * std::sin(azimuth_), z};
}

std::vector<glm::dvec3> Plane::values(const std::vector<PlanePoint>& points) const {
    BrdfQuery query;
    for (const PlanePoint& p : points)
        query.add(p.from.set, viewer(clamped(p.from.view)), light(clamped(p.light)));
    std::vector<glm::dvec3> values;
    const std::vector<BrdfValue> found = probe_.eval(query);
    for (std::size_t i = 0; i < found.size(); ++i) values.push_back(found[i].f / query.second[i].z);
    return values;
}

std::vector<double> Plane::luminances(const std::vector<PlanePoint>& points) const {
    std::vector<double> out;
    for (const glm::dvec3& f : values(points)) out.push_back(luminance(f));
    return out;
}

std::vector<double> Plane::angles(double view) {
    std::vector<double> all;
    for (const double centre : {view, -view, 0.0}) {
        all.push_back(centre);
        for (const double off : distances()) {
            all.push_back(centre - off);
            all.push_back(centre + off);
        }
    }
    for (double part = 0.5; part > 1e-4;
         part *= 0.8)  // where values may go steep, near the horizon
        for (const double side : {-grazing, grazing})
            all.push_back(side * (1 - glm::radians(part)));
    tidy(all);
    return all;
}

// Where the model sends samples, as angles of the plane.
std::vector<double> Plane::sampled_angles(const PlaneView& view) const {
    BrdfQuery numbers;
    Random random(11);
    for (int k = 0; k < 64; ++k)
        numbers.add(view.set, viewer(clamped(view.view)),
                    {random.uniform_float(), random.uniform_float(), random.uniform_float()});
    const glm::dvec3 side = light(glm::half_pi<double>());
    std::vector<double> angles;
    for (const BrdfSampled& s : probe_.sample(numbers))
        if (s.pdf > 0 && s.wi.z > 0 && !s.delta)
            angles.push_back(std::atan2(glm::dot(side, s.wi), s.wi.z));
    return angles;
}

std::vector<PlaneLobe> Plane::lobes(const std::vector<PlaneView>& views) const {
    std::vector<std::vector<double>> angles;
    std::vector<PlanePoint> points;
    for (const PlaneView& view : views) {
        angles.push_back(Plane::angles(view.view));
        const std::vector<double> sampled = sampled_angles(view);
        angles.back().insert(angles.back().end(), sampled.begin(), sampled.end());
        tidy(angles.back());
        for (const double angle : angles.back()) points.push_back({view, angle});
    }
    const std::vector<double> found = luminances(points);
    std::vector<PlaneLobe> lobes;
    for (std::size_t i = 0, place = 0; i < views.size(); place += angles[i++].size())
        lobes.push_back(first_look(angles[i], &found[place], views[i].view));
    sharpen(views, lobes);
    const auto above = fallen_to(0.5, 1, views, lobes), below = fallen_to(0.5, -1, views, lobes);
    for (std::size_t i = 0; i < views.size(); ++i) {
        lobes[i].above = above[i];
        lobes[i].below = below[i];
    }
    return lobes;
}

// The peak proper lies near the largest value seen.
void Plane::sharpen(const std::vector<PlaneView>& views, std::vector<PlaneLobe>& lobes) const {
    const auto around = [&](std::size_t i, double reach) {
        const double last = std::min(last_peak(views[i].view), grazing);
        return Bracket{glm::clamp(lobes[i].at - reach, -last, last),
                       glm::clamp(lobes[i].at + reach, -last, last)};
    };
    std::vector<Bracket> brackets;
    for (std::size_t i = 0; i < views.size(); ++i) brackets.push_back(around(i, 0.02));
    for (int round = 0; round < rounds; ++round) {
        const std::vector<double> found = luminances(inside(views, brackets));
        for (std::size_t i = 0; i < views.size(); ++i) {
            const double* const first = &found[i * (pieces + 1)];
            const auto best = static_cast<int>(std::max_element(first, first + pieces + 1) - first);
            if (first[best] > lobes[i].peak * (1 + rounding)) {
                lobes[i].peak = first[best];
                lobes[i].at = brackets[i].at(best);
            }
            brackets[i] = around(i, (brackets[i].high - brackets[i].low) / pieces);
        }
    }
}

std::vector<std::optional<double>> Plane::fallen_to(double part, int side,
                                                    const std::vector<PlaneView>& views,
                                                    const std::vector<PlaneLobe>& lobes) const {
    const std::vector<double> far = distances();
    std::vector<PlanePoint> points;
    std::vector<double> wanted;
    for (std::size_t i = 0; i < views.size(); ++i) {
        wanted.push_back(lobes[i].base + part * (lobes[i].peak - lobes[i].base));
        for (const double off : far) points.push_back({views[i], lobes[i].at + side * off});
    }
    std::vector<double> found = luminances(points);
    std::vector<Bracket> brackets;  // distances from the peak
    std::vector<std::optional<double>> out(views.size());
    std::vector<char> there;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const double* const first = &found[i * far.size()];
        const auto below = static_cast<std::size_t>(
            std::find_if(first, first + far.size(), [&](double f) { return f <= wanted[i]; }) -
            first);
        const double room = grazing - side * lobes[i].at;  // up to the horizon
        Bracket bracket{0, 0};
        if (below < far.size()) bracket = {below ? far[below - 1] : 0, std::min(far[below], room)};
        there.push_back(lobes[i].any && bracket.low < bracket.high);
        brackets.push_back(bracket);
    }
    for (int round = 0; round < rounds; ++round) {
        std::vector<PlanePoint> within = inside(views, brackets);
        for (std::size_t k = 0; k < within.size(); ++k)
            within[k].light = lobes[k / (pieces + 1)].at + side * within[k].light;
        found = luminances(within);
        for (std::size_t i = 0; i < views.size(); ++i) {
            const double* const first = &found[i * (pieces + 1)];
            const auto below = static_cast<int>(
                std::find_if(first + 1, first + pieces, [&](double f) { return f <= wanted[i]; }) -
                first);
            const double rise = first[below - 1] - first[below];
            const Bracket cut{brackets[i].at(below - 1), brackets[i].at(below)};
            const double at = rise > 0 ? (first[below - 1] - wanted[i]) / rise : 0.5;
            if (there[i]) out[i] = cut.low + (cut.high - cut.low) * glm::clamp(at, 0.0, 1.0);
            brackets[i] = cut;
        }
    }
    return out;
}

}  // namespace lobe
