// SPDX-License-Identifier: Apache-2.0
// What all plots share: inks, axes, and labels that stand at the lines they name.
#pragma once

#include <string>
#include <vector>

#include "report/drawing.h"

namespace lobe {

// Inks of things that are no data, from strong to faint.
constexpr Ink text_ink{34, 34, 34}, note_ink{110, 110, 110}, axis_ink{150, 150, 150},
    grid_ink{228, 228, 228};
constexpr double text_size = 11, title_size = 13, note_size = 10;

// The ink of series i of `count`, from dark to light: their order shows in grey too, and to people
// who do not see all colours. Knots of the map "plasma" (S. van der Walt, N. Smith, 2015).
Ink series_ink(std::size_t i, std::size_t count);

// A number as plots write it: 0.5, 100, 10⁶.
std::string plot_number(double value);

// The text cut to a width, with dots where something is lost.
std::string fitted(const std::string& text, double size, double width);

// A scale from values to positions; `log` wants a positive range.
struct Axis {
    double low, high;
    double from, to;  // positions of low and high
    bool log = false;

    double at(double value) const;
    // Some round values within the range.
    std::vector<double> ticks() const;
};

// The smallest of 1, 2, 2.5, 5 times a power of ten that is no less.
double round_up(double value);

// A line of a plot, in positions.
struct Curve {
    std::vector<glm::dvec2> points;
    Ink ink;
    std::string label;
};

// Places each curve's label beside it, where it covers least of the curves and of other labels,
// within [low, high].
void add_labels(Drawing& drawing, const std::vector<Curve>& curves, const glm::dvec2& low,
                const glm::dvec2& high);

}  // namespace lobe
