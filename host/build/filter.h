// SPDX-License-Identifier: Apache-2.0
// The pixel filter as the camera samples it: by importance, so that pixels share no samples.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace lobe {

struct FilterTable {
    // LOBE_FILTER_NODES of x, then of y: node i is the offset, in half widths, within which the
    // part 1 - v^2 of the integral of |f| lies, v = i / (LOBE_FILTER_NODES - 1)
    std::vector<float> nodes;
    double negative_x, negative_y;  // part of that integral from which f is negative, or infinity
    double weight;                  // of every sample: integral of |f| over integral of f
};

// Value of the filter along one axis at `offset` pixels from the centre (its 2D value is the
// product), unnormalised, 0 beyond its half width `radius`.
double filter_value(const Filter& filter, double radius, double offset);

// Throws Error (scene) for a filter whose integral is not positive, or that turns positive again
// beyond a negative part.
FilterTable tabulate_filter(const Filter& filter);

}  // namespace lobe
