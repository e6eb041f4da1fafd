// SPDX-License-Identifier: Apache-2.0
// The pixel filter as the camera samples it: by importance, so that pixels share no samples.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace lobe {

struct FilterTable {
    std::vector<float> nodes;  // LOBE_FILTER_NODES of x, then of y: offsets in half widths
    double negative_x, negative_y;  // |offset| in pixels from which the filter is negative, or inf
    double weight;                  // of every sample: integral of |f| over integral of f
};

// Value of the filter along one axis at `offset` pixels from the centre (its 2D value is the
// product), unnormalised, 0 beyond its half width `radius`.
double filter_value(const Filter& filter, double radius, double offset);

FilterTable tabulate_filter(const Filter& filter);

}  // namespace lobe
