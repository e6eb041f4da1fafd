// SPDX-License-Identifier: Apache-2.0
// Intervals for figures made of few independent runs, whose law is not known.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace lobe {

struct Interval {
    double low = 0, high = 0;
    bool holds(double value) const { return low <= value && value <= high; }
};

// A figure with a standard error, which need not be exact: it makes the figure's deviations
// comparable between resamples.
struct Studentised {
    double value = 0, error = 0;
};

struct BootstrapOptions {
    double level = 0.95;
    unsigned resamples = 10000;
    std::uint64_t seed = 1;  // the same runs give the same interval
};

// Percentile-t intervals (Efron and Tibshirani, "An Introduction to the Bootstrap", 1993, chapter
// 12.5) of several figures of `runs` independent runs: `figures` is asked for them with lists of
// runs, drawn with replacement. Where t* = (value* - value) / error* has the quantiles q, the
// interval is [value - q(high) error, value - q(low) error]; so it leans as the data do. Resamples
// in which a figure has no finite t* do not count for it; if those are more than one in twenty, or
// there are fewer than three runs, its interval is NaN.
std::vector<Interval> bootstrap(
    std::size_t runs,
    const std::function<std::vector<Studentised>(const std::vector<std::size_t>&)>& figures,
    const BootstrapOptions& options = {});

// The mean of values, with the standard error of it.
Studentised studentised_mean(const std::vector<double>& values);

// The interval of their mean.
Interval bootstrap_mean(const std::vector<double>& values, const BootstrapOptions& options = {});

}  // namespace lobe
