// SPDX-License-Identifier: Apache-2.0
#include "base/chi_square.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/statistics.h"

namespace lobe {

ChiSquare chi_square(const std::vector<double>& counts, std::vector<double> expected, bool scale) {
    if (counts.size() != expected.size() || counts.empty()) return {NAN, NAN, 0};
    const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
    const double mass = std::accumulate(expected.begin(), expected.end(), 0.0);
    if (!(mass > 0)) return {NAN, NAN, 0};
    if (scale)
        for (double& e : expected) e *= all / mass;
    std::vector<std::size_t> order(counts.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
    double statistic = 0, cells = 0, count_pool = 0, expected_pool = 0;
    for (const std::size_t i : order) {
        if (!(expected[i] >= 0)) return {NAN, NAN, 0};
        if (expected[i] <= 0 && counts[i] > 0) return {INFINITY, cells, 0};
        count_pool += counts[i];
        expected_pool += expected[i];
        if (expected_pool < 5 && i != order.back()) continue;
        if (expected_pool > 0) {
            statistic +=
                (count_pool - expected_pool) * (count_pool - expected_pool) / expected_pool;
            ++cells;
        }
        count_pool = expected_pool = 0;
    }
    const double freedom = cells - (scale ? 1 : 0);
    return {statistic, freedom, freedom > 0 ? chi_square_survival(statistic, freedom) : 1};
}

}  // namespace lobe
