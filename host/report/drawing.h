// SPDX-License-Identifier: Apache-2.0
// A line drawing as plain data: what the plots are made of before they become SVG or pixels.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lobe {

struct Ink {
    std::uint8_t red = 0, green = 0, blue = 0;
};

// Lengths are in units of the drawing: one pixel of a screen at its natural size. y points down.
struct Polyline {
    std::vector<glm::dvec2> points;
    Ink ink;
    double width = 1;
};

// A filled polygon, without an edge of its own; where it overlaps itself it is painted once.
struct Area {
    std::vector<glm::dvec2> points;
    Ink ink;
    double opacity = 1;
};

struct Dot {
    glm::dvec2 centre{0};
    double radius = 1;
    Ink ink;
};

enum class Anchor { start, middle, end };

// One line of text; `at` lies on its baseline.
struct Text {
    glm::dvec2 at{0};
    std::string text;
    Ink ink;
    double size = 11;
    Anchor anchor = Anchor::start;
};

// Painted in this order.
struct Drawing {
    double width = 0, height = 0;
    std::string title;  // for readers who do not see it
    std::vector<Area> areas;
    std::vector<Polyline> lines;
    std::vector<Dot> dots;
    std::vector<Text> texts;

    void add(Area area) { areas.push_back(std::move(area)); }
    void add(Polyline line) { lines.push_back(std::move(line)); }
    void add(const Dot& dot) { dots.push_back(dot); }
    void add(Text text) { texts.push_back(std::move(text)); }
};

// About how wide a text is: of the fonts that may show it, DejaVu Sans is among the widest.
double text_width(const std::string& text, double size);

// Distance of a point from the segment a b.
double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b);

// The polyline with the points left out that lie within `tolerance` of the line without them
// (U. Ramer, 1972; D. Douglas, T. Peucker, 1973).
std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& points, double tolerance);

}  // namespace lobe
