// SPDX-License-Identifier: Apache-2.0
#include "report/adaptive.h"

#include <algorithm>
#include <cmath>

#include "report/estimate.h"

namespace lobe {
namespace {

constexpr double least_rate = 0.125, most_rate = 8;
constexpr double own_part = 0.5, neighbours_part = 0.4, mean_part = 0.1;

// Mean over a tile's unmasked pixels of the squared error of luminance; 0 of none.
double tile_variance(const Estimate& picture, const PixelBox& box) {
    double sum = 0;
    std::size_t count = 0;
    for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
        for (std::uint32_t x = box.x; x < box.x + box.width; ++x) {
            const std::size_t p = std::size_t{y} * picture.width + x;
            if (picture.sees_light[p]) continue;
            sum += double{picture.luminance_error[p]} * picture.luminance_error[p];
            ++count;
        }
    return count ? sum / static_cast<double>(count) : 0;
}

// The mean over a tile's neighbours, up to eight.
double around(const std::vector<double>& values, std::uint32_t across, std::uint32_t tile) {
    const std::int64_t x = tile % across, y = tile / across;
    const auto down = static_cast<std::int64_t>(values.size() / across);
    double sum = 0;
    int count = 0;
    for (std::int64_t j = std::max<std::int64_t>(y - 1, 0); j <= std::min(y + 1, down - 1); ++j)
        for (std::int64_t i = std::max<std::int64_t>(x - 1, 0);
             i <= std::min<std::int64_t>(x + 1, across - 1); ++i) {
            if (i == x && j == y) continue;
            sum += values[static_cast<std::size_t>(j * across + i)];
            ++count;
        }
    return count ? sum / count : values[tile];
}

// Scales the rates to mean 1 over pixels within their limits.
void normalise(std::vector<double>& rates, const std::vector<double>& pixels) {
    for (int pass = 0; pass < 20; ++pass) {
        double sum = 0, all = 0;
        for (std::size_t t = 0; t < rates.size(); ++t) {
            sum += rates[t] * pixels[t];
            all += pixels[t];
        }
        for (double& rate : rates) rate = std::clamp(rate * all / sum, least_rate, most_rate);
    }
}

}  // namespace

std::uint32_t pilot_samples(std::uint32_t samples) {
    if (samples == 0) return 2 * LOBE_BLOCK;
    const std::uint32_t sixteenth = samples / 16 / LOBE_BLOCK * LOBE_BLOCK;
    return std::clamp<std::uint32_t>(sixteenth, LOBE_BLOCK, 8 * LOBE_BLOCK);
}

std::uint64_t pilot_seed(std::uint64_t seed) { return seed ^ 0x70696c6f74ull << 24; }

std::vector<float> tile_rates(const Film& pilot) {
    const Estimate picture = estimate(pilot);
    std::vector<float> even(pilot.tiles(), 1.0f);
    if (picture.luminance_error.empty()) return even;
    std::vector<double> variances(pilot.tiles()), pixels(pilot.tiles());
    double sum = 0;
    for (std::uint32_t t = 0; t < pilot.tiles(); ++t) {
        const PixelBox box = pilot.tile_box(t);
        variances[t] = tile_variance(picture, box) * pilot.tile_samples(t);
        pixels[t] = static_cast<double>(box.pixels());
        sum += variances[t] * pixels[t];
    }
    if (!(sum > 0)) return even;
    const double mean = sum / static_cast<double>(pilot.pixels());
    const std::uint32_t across = (pilot.width() + LOBE_TILE - 1) / LOBE_TILE;
    std::vector<double> rates(pilot.tiles());
    for (std::uint32_t t = 0; t < pilot.tiles(); ++t)
        rates[t] = std::sqrt(own_part * variances[t] +
                             neighbours_part * around(variances, across, t) + mean_part * mean);
    normalise(rates, pixels);
    return {rates.begin(), rates.end()};
}

}  // namespace lobe
