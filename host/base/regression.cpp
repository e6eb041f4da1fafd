// SPDX-License-Identifier: Apache-2.0
#include "base/regression.h"

#include <cmath>
#include <limits>

#include "base/statistics.h"

namespace lobe {
namespace {

LineFit no_fit() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, nan, nan, nan, 0};
}

}  // namespace

double LineFit::error_at(double x) const {
    return std::sqrt(std::fmax(0, intercept_error * intercept_error + 2 * x * covariance +
                                      x * x * slope_error * slope_error));
}

double LineFit::p() const { return freedom > 0 ? chi_square_survival(chi_square, freedom) : 1; }

// About the weighted mean of x, where slope and height have no covariance and nothing cancels.
LineFit fit_line(const std::vector<double>& x, const std::vector<double>& y,
                 const std::vector<double>& variance) {
    double weights = 0, mean_x = 0, mean_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!(variance[i] > 0 && std::isfinite(variance[i]))) return no_fit();
        const double w = 1 / variance[i];
        weights += w;
        mean_x += w / weights * (x[i] - mean_x);
        mean_y += w / weights * (y[i] - mean_y);
    }
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = x[i] - mean_x;
        xx += dx * dx / variance[i];
        xy += dx * (y[i] - mean_y) / variance[i];
    }
    if (x.size() < 2 || !(xx > 0)) return no_fit();
    LineFit fit;
    fit.slope = xy / xx;
    fit.intercept = mean_y - fit.slope * mean_x;
    fit.slope_error = std::sqrt(1 / xx);
    fit.intercept_error = std::sqrt(1 / weights + mean_x * mean_x / xx);
    fit.covariance = -mean_x / xx;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double residual = y[i] - mean_y - fit.slope * (x[i] - mean_x);
        fit.chi_square += residual * residual / variance[i];
    }
    fit.freedom = static_cast<double>(x.size()) - 2;
    return fit;
}

double theil_sen_slope(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (x[i] != x[j]) slopes.push_back((y[i] - y[j]) / (x[i] - x[j]));
    return median(slopes);
}

double theil_sen_intercept(const std::vector<double>& x, const std::vector<double>& y,
                           double slope) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < x.size(); ++i) heights.push_back(y[i] - slope * x[i]);
    return median(heights);
}

}  // namespace lobe
