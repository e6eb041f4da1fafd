// SPDX-License-Identifier: Apache-2.0
#include "support/chi_square.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/statistics.h"

namespace lobe::test {

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

testing::AssertionResult follows(const std::vector<double>& counts,
                                 const std::vector<double>& expected, double tests, bool scale) {
    const ChiSquare result = chi_square(counts, expected, scale);
    const double level = sidak(family_alpha, tests);
    auto verdict = result.p >= level ? testing::AssertionSuccess() : testing::AssertionFailure();
    return verdict << "chi-square " << result.statistic << " with " << result.freedom
                   << " degrees of freedom, p = " << result.p << ", level " << level;
}

testing::AssertionResult normal_deviate(double z, double tests) {
    const double p = two_sided_p(z), level = sidak(family_alpha, tests);
    auto verdict = p >= level ? testing::AssertionSuccess() : testing::AssertionFailure();
    return verdict << "z = " << z << ", p = " << p << ", level " << level;
}

}  // namespace lobe::test
