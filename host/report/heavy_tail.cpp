// SPDX-License-Identifier: Apache-2.0
#include "report/heavy_tail.h"

#include <algorithm>
#include <cmath>

namespace lobe {
namespace {

constexpr std::uint32_t side = 8;  // of a pixel's surroundings

}  // namespace

std::optional<TailIndex> error_tail(const Estimate& e) {
    if (e.luminance_error.empty()) return {};
    double square_sum = 0;
    for (const float error : e.luminance_error) square_sum += double{error} * error;
    // Where nearly all is quiet, a few pixels' noise is no tail.
    const double least =
        0.01 * std::sqrt(square_sum / static_cast<double>(e.luminance_error.size()));
    std::vector<double> scaled;
    for (std::uint32_t y0 = 0; y0 < e.height; y0 += side)
        for (std::uint32_t x0 = 0; x0 < e.width; x0 += side) {
            std::vector<double> errors;
            for (std::uint32_t y = y0; y < std::min(y0 + side, e.height); ++y)
                for (std::uint32_t x = x0; x < std::min(x0 + side, e.width); ++x) {
                    const std::size_t p = std::size_t{y} * e.width + x;
                    if (!e.sees_light[p]) errors.push_back(e.luminance_error[p]);
                }
            if (errors.size() < side * side / 2) continue;
            std::vector<double> sorted = errors;
            std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
            const double typical = std::max(sorted[sorted.size() / 2], least);
            for (const double error : errors) scaled.push_back(error / typical);
        }
    if (scaled.size() < 2000) return {};
    return tail_index(std::move(scaled));
}

}  // namespace lobe
