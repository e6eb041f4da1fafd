// SPDX-License-Identifier: Apache-2.0
#include "base/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/random.h"
#include "base/statistics.h"

namespace lobe {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Of sorted values, interpolated between neighbours.
double quantile(const std::vector<double>& sorted, double p) {
    const double place = p * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    if (below + 1 >= sorted.size()) return sorted.back();
    return sorted[below] + (place - std::floor(place)) * (sorted[below + 1] - sorted[below]);
}

Interval percentile_t(const Studentised& figure, std::vector<double> deviations,
                      const BootstrapOptions& options) {
    if (!(std::isfinite(figure.value) && std::isfinite(figure.error)) ||
        deviations.size() < 0.95 * options.resamples)
        return {nan, nan};
    std::sort(deviations.begin(), deviations.end());
    const double tail = 0.5 * (1 - options.level);
    return {figure.value - quantile(deviations, 1 - tail) * figure.error,
            figure.value - quantile(deviations, tail) * figure.error};
}

}  // namespace

std::vector<Interval> bootstrap(
    std::size_t runs,
    const std::function<std::vector<Studentised>(const std::vector<std::size_t>&)>& figures,
    const BootstrapOptions& options) {
    std::vector<std::size_t> chosen(runs);
    std::iota(chosen.begin(), chosen.end(), 0);
    const std::vector<Studentised> whole = figures(chosen);
    if (runs < 3) return std::vector<Interval>(whole.size(), {nan, nan});
    std::vector<std::vector<double>> deviations(whole.size());
    Random random(options.seed);
    for (unsigned i = 0; i < options.resamples; ++i) {
        for (std::size_t& run : chosen) run = random.below(static_cast<std::uint32_t>(runs));
        const std::vector<Studentised> drawn = figures(chosen);
        for (std::size_t f = 0; f < whole.size(); ++f) {
            const double t = (drawn[f].value - whole[f].value) / drawn[f].error;
            if (std::isfinite(t)) deviations[f].push_back(t);
        }
    }
    std::vector<Interval> intervals;
    for (std::size_t f = 0; f < whole.size(); ++f)
        intervals.push_back(percentile_t(whole[f], std::move(deviations[f]), options));
    return intervals;
}

Studentised studentised_mean(const std::vector<double>& values) {
    return {mean(values), standard_error(values)};
}

Interval bootstrap_mean(const std::vector<double>& values, const BootstrapOptions& options) {
    std::vector<double> drawn(values.size());
    return bootstrap(
        values.size(),
        [&](const std::vector<std::size_t>& chosen) {
            for (std::size_t i = 0; i < chosen.size(); ++i) drawn[i] = values[chosen[i]];
            return std::vector<Studentised>{studentised_mean(drawn)};
        },
        options)[0];
}

}  // namespace lobe
