// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/drawing.h"

namespace lobe {

struct Histogram {
    std::string title, x_label;
    std::vector<double> values;
    double low = 0, high = 1;  // the axis, inclusive; as of p-values
    std::size_t bins = 20;
    // A band where 95 % of the counts lie if all values of the axis are as likely, as p-values are
    // under the null hypothesis (normal approximation of the binomial).
    bool uniform_band = true;
};

// Counts a bin; values outside the axis or not finite are left out.
Drawing draw(const Histogram& histogram);

// The counts that it shows.
std::vector<std::size_t> counts(const Histogram& histogram);

}  // namespace lobe
