// SPDX-License-Identifier: Apache-2.0
#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lobe {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double tiny = 1e-300;
constexpr int most_terms = 1000000;

double away_from_zero(double x) { return std::fabs(x) < tiny ? tiny : x; }

// Continued fraction of the incomplete beta function by Lentz's method (DLMF 8.17.22); quick for
// x < (a + 1) / (a + b + 2).
double beta_fraction(double x, double a, double b) {
    double c = 1, d = 1 / away_from_zero(1 - (a + b) * x / (a + 1)), value = d;
    for (int m = 1; m < most_terms; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        d = 1 / away_from_zero(1 + even * d);
        c = away_from_zero(1 + even / c);
        value *= d * c;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 / away_from_zero(1 + odd * d);
        c = away_from_zero(1 + odd / c);
        value *= d * c;
        if (std::fabs(d * c - 1) <= epsilon) break;
    }
    return value;
}

// Regularised incomplete beta function I_x(a, b), given also y = 1 - x.
double incomplete_beta(double x, double y, double a, double b) {
    if (x <= 0) return 0;
    if (y <= 0) return 1;
    const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                  a * std::log(x) + b * std::log(y));
    if (x < (a + 1) / (a + b + 2)) return front * beta_fraction(x, a, b) / a;
    return 1 - front * beta_fraction(y, b, a) / b;
}

// The x <= 0 where an increasing lower-tail function reaches p, for 0 < p <= its value at 0.
template <typename Tail>
double invert_lower_tail(const Tail& tail, double p) {
    double low = -1, high = 0;
    while (tail(low) > p) {
        high = low;
        low *= 2;
    }
    while (true) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) return middle;
        (tail(middle) < p ? low : high) = middle;
    }
}

template <typename Tail>
double symmetric_quantile(const Tail& tail, double p) {
    if (!(p >= 0 && p <= 1)) return nan;
    if (p == 0) return -inf;
    if (p == 1) return inf;
    if (p == 0.5) return 0;
    return p < 0.5 ? invert_lower_tail(tail, p) : -invert_lower_tail(tail, 1 - p);
}

}  // namespace

double mean(const std::vector<double>& values) {
    long double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? nan : static_cast<double>(sum / values.size());
}

double sample_variance(const std::vector<double>& values) {
    if (values.size() < 2) return nan;
    const double middle = mean(values);
    long double sum = 0;
    for (const double value : values) sum += (value - middle) * (value - middle);
    return static_cast<double>(sum / (values.size() - 1));
}

double standard_error(const std::vector<double>& values) {
    return std::sqrt(sample_variance(values) / static_cast<double>(values.size()));
}

double median(std::vector<double> values) {
    if (values.empty()) return nan;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double deviation_from(std::vector<double> values, double centre) {
    for (double& value : values) value = std::abs(value - centre);
    return 1.4826 * median(values);
}

double normal_cdf(double z) { return 0.5 * std::erfc(-z * std::sqrt(0.5)); }
double normal_quantile(double p) { return symmetric_quantile(normal_cdf, p); }
double two_sided_p(double z) { return std::erfc(std::fabs(z) * std::sqrt(0.5)); }

double student_cdf(double t, double freedom) {
    if (std::isnan(t) || !(freedom > 0)) return nan;
    if (std::isinf(freedom)) return normal_cdf(t);
    const double ratio = t * t / freedom;
    const double tail =
        std::isinf(ratio)
            ? 0
            : 0.5 * incomplete_beta(1 / (1 + ratio), ratio / (1 + ratio), 0.5 * freedom, 0.5);
    return t < 0 ? tail : 1 - tail;
}

double student_quantile(double p, double freedom) {
    if (!(freedom > 0)) return nan;
    return symmetric_quantile([&](double t) { return student_cdf(t, freedom); }, p);
}

// Regularised incomplete gamma function Q(freedom / 2, x / 2): one minus the power series (DLMF
// 8.11.4) left of the hump, Lentz's continued fraction (DLMF 8.9.2) right of it.
double chi_square_survival(double x, double freedom) {
    if (std::isnan(x) || !(freedom > 0)) return nan;
    if (x <= 0) return 1;
    if (std::isinf(x)) return 0;
    const double a = 0.5 * freedom, y = 0.5 * x;
    const double front = std::exp(a * std::log(y) - y - std::lgamma(a));
    if (y < a + 1) {
        double term = 1 / a, sum = term;
        for (int k = 1; k < most_terms && term > epsilon * sum; ++k) sum += term *= y / (a + k);
        return 1 - front * sum;
    }
    double b = y + 1 - a, c = 1 / tiny, d = 1 / b, value = d;
    for (int k = 1; k < most_terms; ++k) {
        const double step = k * (a - k);
        b += 2;
        d = 1 / away_from_zero(b + step * d);
        c = away_from_zero(b + step / c);
        value *= d * c;
        if (std::fabs(d * c - 1) <= epsilon) break;
    }
    return front * value;
}

double sidak(double alpha, double tests) { return -std::expm1(std::log1p(-alpha) / tests); }

}  // namespace lobe
