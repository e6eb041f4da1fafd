// SPDX-License-Identifier: Apache-2.0
#include "base/rank_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/statistics.h"

namespace lobe {
namespace {

constexpr std::size_t most_exact = 50;

// Twice the mean rank of each size, a whole number, in the order of rising size.
struct Ranks {
    std::vector<std::size_t> doubled;
    std::size_t positive = 0;  // sum of those of positive differences
    double tie_term = 0;       // sum of t^3 - t over groups of t equal sizes
};

Ranks rank(std::vector<double> differences) {
    const auto zero = [](double d) { return d == 0; };
    differences.erase(std::remove_if(differences.begin(), differences.end(), zero),
                      differences.end());
    std::sort(differences.begin(), differences.end(),
              [](double a, double b) { return std::fabs(a) < std::fabs(b); });
    Ranks ranks;
    for (std::size_t first = 0, end; first < differences.size(); first = end) {
        end = first + 1;
        while (end < differences.size() &&
               std::fabs(differences[end]) == std::fabs(differences[first]))
            ++end;
        const double group = static_cast<double>(end - first);
        ranks.tie_term += group * group * group - group;
        for (std::size_t i = first; i < end; ++i) {
            ranks.doubled.push_back(first + 1 + end);
            if (differences[i] > 0) ranks.positive += ranks.doubled.back();
        }
    }
    return ranks;
}

// Probability that ranks with random signs sum to `least` or less, by adding one rank after the
// other to the distribution.
double lower_tail(const std::vector<std::size_t>& ranks, std::size_t least) {
    std::vector<double> chance(least + 1, 0.0);
    chance[0] = 1;
    for (std::size_t rank : ranks)
        for (std::size_t sum = least + 1; sum-- > 0;)
            chance[sum] = 0.5 * (chance[sum] + (sum >= rank ? chance[sum - rank] : 0));
    return std::accumulate(chance.begin(), chance.end(), 0.0);
}

// Places of the p-values, smallest first.
std::vector<std::size_t> order_of(const std::vector<double>& p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
    return order;
}

}  // namespace

MeanInterval mean_interval(const std::vector<double>& values, double confidence) {
    MeanInterval interval;
    interval.mean = mean(values);
    interval.deviation = std::sqrt(sample_variance(values));
    const double freedom = static_cast<double>(values.size()) - 1;
    const double error = standard_error(values);
    const double half = student_quantile(0.5 + 0.5 * confidence, freedom) * error;
    interval.lo = interval.mean - half;
    interval.hi = interval.mean + half;
    if (error > 0)
        interval.p = 2 * student_cdf(-std::fabs(interval.mean) / error, freedom);
    else if (error == 0)
        interval.p = interval.mean == 0 ? 1 : 0;
    else
        interval.p = std::numeric_limits<double>::quiet_NaN();
    return interval;
}

double signed_rank_p(const std::vector<double>& differences) {
    const Ranks ranks = rank(differences);
    const double n = static_cast<double>(ranks.doubled.size());
    if (n == 0) return 1;
    const std::size_t all = ranks.doubled.size() * (ranks.doubled.size() + 1);
    const std::size_t least = std::min(ranks.positive, all - ranks.positive);
    if (ranks.doubled.size() <= most_exact)
        return std::min(1.0, 2 * lower_tail(ranks.doubled, least));
    const double variance = n * (n + 1) * (2 * n + 1) / 24 - ranks.tie_term / 48;
    const double away = 0.5 * (0.5 * static_cast<double>(all) - static_cast<double>(least));
    return two_sided_p(std::max(0.0, away - 0.5) / std::sqrt(variance));
}

std::vector<double> holm(const std::vector<double>& p) {
    std::vector<double> adjusted(p.size());
    double highest = 0;
    std::size_t left = p.size();
    for (std::size_t place : order_of(p)) {
        highest = std::max(highest, std::min(1.0, p[place] * static_cast<double>(left--)));
        adjusted[place] = highest;
    }
    return adjusted;
}

std::vector<double> holm_levels(const std::vector<double>& p, double alpha) {
    std::vector<double> levels(p.size());
    std::size_t left = p.size();
    for (std::size_t place : order_of(p)) levels[place] = alpha / static_cast<double>(left--);
    return levels;
}

}  // namespace lobe
