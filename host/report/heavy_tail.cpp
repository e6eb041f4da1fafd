// SPDX-License-Identifier: Apache-2.0
#include "report/heavy_tail.h"

#include <algorithm>
#include <cmath>

namespace lobe {
namespace {

// The second largest error around a pixel: what is typical there, at the edge of a noisy region and
// along a noisy line too. Masked pixels do not count.
double typical_around(const Estimate& e, std::uint32_t x, std::uint32_t y) {
    float first = 0, second = 0;
    for (std::uint32_t v = y ? y - 1 : 0; v <= std::min(y + 1, e.height - 1); ++v)
        for (std::uint32_t u = x ? x - 1 : 0; u <= std::min(x + 1, e.width - 1); ++u) {
            const std::size_t p = std::size_t{v} * e.width + u;
            if ((u == x && v == y) || e.sees_light[p]) continue;
            const float error = e.luminance_error[p];
            second = std::max(second, std::min(first, error));
            first = std::max(first, error);
        }
    return second;
}

}  // namespace

std::optional<TailIndex> error_tail(const Estimate& e) {
    if (e.luminance_error.empty()) return {};
    double square_sum = 0;
    for (const float error : e.luminance_error) square_sum += double{error} * error;
    // Where nearly all is quiet, a few pixels' noise is no tail.
    const double least =
        0.01 * std::sqrt(square_sum / static_cast<double>(e.luminance_error.size()));
    std::vector<double> scaled;
    for (std::uint32_t y = 0; y < e.height; ++y)
        for (std::uint32_t x = 0; x < e.width; ++x) {
            const std::size_t p = std::size_t{y} * e.width + x;
            if (!e.sees_light[p] && least > 0)
                scaled.push_back(e.luminance_error[p] / std::max(typical_around(e, x, y), least));
        }
    if (scaled.size() < 2000) return {};
    return tail_index(std::move(scaled));
}

}  // namespace lobe
