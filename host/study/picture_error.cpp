// SPDX-License-Identifier: Apache-2.0
#include "study/picture_error.h"

#include <algorithm>
#include <cmath>

#include "base/luminance.h"

namespace lobe {
namespace {

double variance_of(const Reference& reference, std::size_t pixel) {
    if (reference.luminance_error.empty()) return 0;  // taken to be exact
    const double error = reference.luminance_error[pixel];
    return error * error;
}

double squared_mean(const Reference& reference, const std::vector<bool>& masked) {
    double sum = 0, pixels = 0;
    for (std::size_t p = 0; p < masked.size(); ++p) {
        if (masked[p]) continue;
        sum += luminance(&reference.rgb[3 * p]);
        ++pixels;
    }
    return pixels > 0 ? sum * sum / (pixels * pixels) : 0;
}

struct PixelError {
    double squared, corrected;
};

}  // namespace

PictureError picture_error(const Estimate& picture, const Reference& reference,
                           const std::vector<bool>& masked) {
    std::vector<PixelError> errors;
    errors.reserve(masked.size());
    double squares = 0, sum = 0;
    for (std::size_t p = 0; p < masked.size(); ++p) {
        if (masked[p]) continue;
        const double difference = luminance(&picture.rgb[3 * p]) - luminance(&reference.rgb[3 * p]);
        const double squared = difference * difference;
        errors.push_back({squared, squared - variance_of(reference, p)});
        squares += squared;
        sum += errors.back().corrected;
    }
    const double scale = squared_mean(reference, masked);
    if (errors.empty() || !(scale > 0)) return {};
    const auto pixels = static_cast<double>(errors.size());
    const std::size_t dropped = (errors.size() + 999) / 1000;
    std::nth_element(
        errors.begin(), errors.begin() + (dropped - 1), errors.end(),
        [](const PixelError& a, const PixelError& b) { return a.squared > b.squared; });
    double dropped_squares = 0, dropped_sum = 0;
    for (std::size_t i = 0; i < dropped; ++i) {
        dropped_squares += errors[i].squared;
        dropped_sum += errors[i].corrected;
    }
    PictureError error;
    error.mse = sum / pixels / scale;
    if (errors.size() > dropped)
        error.mse_trimmed = (sum - dropped_sum) / (pixels - static_cast<double>(dropped)) / scale;
    if (squares > 0) error.trimmed_share = dropped_squares / squares;
    return error;
}

double reference_variance(const Reference& reference, const std::vector<bool>& masked) {
    double sum = 0, pixels = 0;
    for (std::size_t p = 0; p < masked.size(); ++p) {
        if (masked[p]) continue;
        sum += variance_of(reference, p);
        ++pixels;
    }
    const double scale = squared_mean(reference, masked);
    return pixels > 0 && scale > 0 ? sum / pixels / scale : 0;
}

}  // namespace lobe
