// SPDX-License-Identifier: Apache-2.0
// How heavy the tail of a distribution is, seen at its largest values.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace lobe {

struct TailIndex {
    double alpha = 0;       // P(X > x) falls like x^-alpha; below 2 the variance is infinite
    double error = 0;       // standard error: alpha / sqrt(count)
    std::size_t count = 0;  // values used
    double threshold = 0;   // the value that they all exceed or equal

    // Whether the variance may be infinite and intervals that take it to be finite are not to be
    // trusted.
    bool heavy() const { return alpha < 2; }
};

// Hill's estimator (1975) over the `largest` greatest values: one over the mean of the logarithms
// of their ratios to the next one below. Nothing if there are fewer than largest + 1 positive
// values, or those are all the same. It says what the tail does if it is a power of x; lighter
// tails give a large alpha that grows with the number of values.
std::optional<TailIndex> tail_index(std::vector<double> values, std::size_t largest = 64);

}  // namespace lobe
