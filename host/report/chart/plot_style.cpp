// SPDX-License-Identifier: Apache-2.0
#include "report/chart/plot_style.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace lobe {
namespace {

std::string superscript(int number) {
    static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : std::to_string(number)) text += c == '-' ? "⁻" : digits[c - '0'];
    return text;
}

struct Box {
    glm::dvec2 low, high;
    bool holds(const glm::dvec2& p) const {
        return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
    }
    bool meets(const Box& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
               other.low.y <= high.y;
    }
};

// Points of a line at even steps of its length.
std::vector<glm::dvec2> stepped(const std::vector<glm::dvec2>& points, double step) {
    std::vector<glm::dvec2> out;
    double left = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 along = points[i] - points[i - 1];
        const double length = glm::length(along);
        for (; left < length; left += step) out.push_back(points[i - 1] + left / length * along);
        left -= length;
    }
    return out;
}

// 1, 2, 5 times powers of ten within a range.
std::vector<double> values_1_2_5(double low, double high) {
    std::vector<double> all;
    for (double e = std::floor(std::log10(low)); e <= std::log10(high); e += 1)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double value = digit * std::pow(10.0, e);
            if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) all.push_back(value);
        }
    return all;
}

}  // namespace

Ink series_ink(std::size_t i, std::size_t count) {
    static constexpr Ink knots[] = {
        {13, 8, 135}, {106, 0, 168}, {177, 42, 144}, {225, 100, 98}, {252, 166, 54}};
    const double place =
        count > 1 ? 4.0 * static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    const auto knot = std::min<std::size_t>(static_cast<std::size_t>(place), 3);
    const double t = place - static_cast<double>(knot);
    const auto mix = [t](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(a + t * (b - a)));
    };
    return {mix(knots[knot].red, knots[knot + 1].red),
            mix(knots[knot].green, knots[knot + 1].green),
            mix(knots[knot].blue, knots[knot + 1].blue)};
}

std::string plot_number(double value) {
    if (value == 0) return "0";  // and never -0
    const double exponent = std::floor(std::log10(std::abs(value)) + 1e-9);
    if (exponent > -4 && exponent < 4) {
        char text[32];
        std::snprintf(text, sizeof text, "%.4g", value);
        return text;
    }
    const double mantissa = value / std::pow(10.0, exponent);
    const std::string power = "10" + superscript(static_cast<int>(exponent));
    return std::abs(mantissa - 1) < 1e-6 ? power : plot_number(mantissa) + "·" + power;
}

double Axis::at(double value) const {
    const double part =
        log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return from + part * (to - from);
}

std::vector<double> Axis::ticks() const {
    std::vector<double> all;
    if (log) {
        const double decades = std::log10(high / low);
        const double step = std::max(1.0, std::ceil(decades / 6));
        for (double e = std::ceil(std::log10(low) - 1e-9); e <= std::log10(high) + 1e-9; e += step)
            all.push_back(std::pow(10.0, e));
        if (all.size() < 3) all = values_1_2_5(low, high);
        if (all.size() >= 2) return all;
        all.clear();
    }
    const double step = round_up((high - low) / 5.5);
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1)
        all.push_back(k * step);
    return all;
}

double round_up(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-12));
    for (const double digit : {1.0, 2.0, 2.5, 5.0})
        if (digit * power >= value * (1 - 1e-12)) return digit * power;
    return 10 * power;
}

std::string fitted(const std::string& text, double size, double width) {
    if (text_width(text, size) <= width) return text;
    std::string cut = text;
    while (!cut.empty() && text_width(cut + "...", size) > width) cut.pop_back();
    return cut + "...";
}

namespace {

// The places for a label at a point of its curve: beside, above and below it, and what is less
// liked about them.
struct Place {
    Box box;
    double cost;
};

std::vector<Place> places_at(const glm::dvec2& p, double width, double height) {
    const glm::dvec2 half(width / 2 + 2, height / 2 + 2);
    const double x = half.x + 4, y = half.y + 4;
    std::vector<Place> places;
    for (const auto& [off, cost] :
         {std::pair(glm::dvec2(x, 0), 0.0), {{-x, 0}, 1.5}, {{0, -y}, 3.0}, {{0, y}, 3.0}})
        places.push_back({{p + off - half, p + off + half}, cost});
    return places;
}

// How much of other curves and labels a place covers or comes near.
double cost_of(const Box& box, std::size_t own, const std::vector<std::vector<glm::dvec2>>& inked,
               const std::vector<Box>& taken) {
    const Box wide{box.low - 8.0, box.high + 8.0};  // where others mislead
    double cost = 0;
    for (std::size_t i = 0; i < inked.size(); ++i)
        for (const glm::dvec2& q : inked[i])
            cost += box.holds(q) ? 4 : i != own && wide.holds(q) ? 0.4 : 0;
    for (const Box& other : taken) cost += box.meets(other) ? 1000 : 0;
    return cost;
}

}  // namespace

void add_labels(Drawing& drawing, const std::vector<Curve>& curves, const glm::dvec2& low,
                const glm::dvec2& high) {
    std::vector<std::vector<glm::dvec2>> inked;
    for (const Curve& curve : curves) inked.push_back(stepped(curve.points, 1));
    std::vector<Box> taken;
    const Box bounds{low, high};
    const double middle = 0.5 * (low.y + high.y), height = 0.75 * text_size;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (curves[i].label.empty()) continue;
        const double width = text_width(curves[i].label, text_size);
        Place best{{}, std::numeric_limits<double>::infinity()};
        for (const glm::dvec2& p : stepped(curves[i].points, 3))
            for (Place place : places_at(p, width, height)) {
                if (!bounds.holds(place.box.low) || !bounds.holds(place.box.high)) continue;
                place.cost += 0.01 * std::abs(p.y - middle) + cost_of(place.box, i, inked, taken);
                if (place.cost < best.cost) best = place;
            }
        if (std::isinf(best.cost)) continue;
        taken.push_back(best.box);
        const glm::dvec2 centre = 0.5 * (best.box.low + best.box.high);
        drawing.add(Text{{centre.x, centre.y + height / 2},
                         curves[i].label,
                         curves[i].ink,
                         text_size,
                         Anchor::middle});
    }
}

}  // namespace lobe
