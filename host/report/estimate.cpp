// SPDX-License-Identifier: Apache-2.0
#include "report/estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/luminance.h"
#include "base/sha256.h"
#include "base/statistics.h"

namespace lobe {
namespace {

// One pixel's sums, by replicate. Sample s belongs to replicate s % LOBE_REPLICATES.
class PixelSums {
  public:
    static constexpr int luminance = 3;  // the channel after red, green and blue

    PixelSums(const double* sums, std::uint32_t samples) : samples_(samples) {
        for (unsigned r = 0; r < LOBE_REPLICATES; ++r) {
            sizes_[r] = static_cast<double>((samples + LOBE_REPLICATES - 1 - r) / LOBE_REPLICATES);
            for (int c = 0; c < 3; ++c) sums_[c][r] = sums[3 * r + c];
            sums_[luminance][r] = lobe::luminance(sums + 3 * r);
        }
    }

    double mean(int channel) const {
        double total = 0;
        for (const double sum : sums_[channel]) total += sum;
        return total / samples_;
    }

    // Of the mean: the spread of the replicates' means, weighed by their sizes, over the number of
    // samples. LOBE_REPLICATES - 1 degrees of freedom; every replicate must have a sample.
    double variance(int channel) const {
        const double middle = mean(channel);
        double spread = 0;
        for (unsigned r = 0; r < LOBE_REPLICATES; ++r) {
            const double difference = sums_[channel][r] / sizes_[r] - middle;
            spread += sizes_[r] * difference * difference;
        }
        return spread / (LOBE_REPLICATES - 1) / samples_;
    }

  private:
    double samples_;
    std::array<double, LOBE_REPLICATES> sizes_;
    std::array<std::array<double, LOBE_REPLICATES>, 4> sums_;
};

// Effective degrees of freedom of a sum of the pixels' variances, each with LOBE_REPLICATES - 1:
// Satterthwaite's, with the squares of the true variances estimated from those of the variances.
double freedom(double variances, double squares) {
    return squares > 0 ? (LOBE_REPLICATES + 1) * variances * variances / squares : 1;
}

}  // namespace

Estimate estimate(const Film& film) {
    const FilmSums sums = film.sums();
    Estimate e;
    e.width = film.width();
    e.height = film.height();
    e.samples = film.samples();
    e.mean_samples = film.mean_samples();
    e.rgb.assign(film.pixels() * 3, 0.0f);
    e.sees_light.resize(film.pixels());
    e.sample_counts = sums.samples;
    e.replicates = std::min<std::uint32_t>(e.samples, LOBE_REPLICATES);
    const bool known = e.replicates == LOBE_REPLICATES;
    if (known) e.standard_error.resize(film.pixels() * 3);
    if (known) e.luminance_error.resize(film.pixels());

    double luminance_sum = 0, variance_sum = 0, square_sum = 0;
    double all_luminance = 0, all_variance = 0, all_squares = 0;
    for (std::size_t p = 0; p < film.pixels(); ++p) {
        if (sums.samples[p] == 0) continue;
        const PixelSums pixel(&sums.radiance[p * LOBE_REPLICATES * 3], sums.samples[p]);
        for (int c = 0; c < 3; ++c) e.rgb[3 * p + c] = static_cast<float>(pixel.mean(c));
        if (known)
            for (int c = 0; c < 3; ++c)
                e.standard_error[3 * p + c] = static_cast<float>(std::sqrt(pixel.variance(c)));
        const double value = pixel.mean(PixelSums::luminance);
        const double variance = known ? pixel.variance(PixelSums::luminance) : 0;
        all_luminance += value;
        all_variance += variance;
        all_squares += variance * variance;
        if (known) e.luminance_error[p] = static_cast<float>(std::sqrt(variance));
        if (sums.emitters[p] > 0) {
            ++e.masked;
            e.sees_light[p] = true;
            continue;
        }
        luminance_sum += value;
        variance_sum += variance;
        square_sum += variance * variance;
    }
    const auto all = static_cast<double>(film.pixels());
    e.image_mean = all_luminance / all;
    if (known) e.image_mean_standard_error = std::sqrt(all_variance) / all;
    e.image_mean_freedom = freedom(all_variance, all_squares);
    const double counted = static_cast<double>(film.pixels() - e.masked);
    if (counted == 0) return e;
    e.mean = luminance_sum / counted;
    if (!known) return e;
    e.mean_standard_error = std::sqrt(variance_sum) / counted;
    e.mean_freedom = freedom(variance_sum, square_sum);
    e.mean_square_error = variance_sum / counted;
    e.mean_square_error_deviation = std::sqrt(square_sum) / counted;
    if (e.mean > 0) e.relative_standard_error = std::sqrt(e.mean_square_error) / e.mean;
    return e;
}

double relative_error_bound(const Estimate& e, double confidence) {
    if (!e.relative_standard_error) return std::numeric_limits<double>::infinity();
    const double spread = normal_quantile(confidence) * e.mean_square_error_deviation;
    return std::sqrt(e.mean_square_error + spread) / e.mean;
}

std::array<double, 2> relative_error_interval(const Estimate& e) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    if (!e.relative_standard_error) return {unknown, unknown};
    const double error = *e.relative_standard_error;
    if (e.mean_square_error <= 0) return {error, error};
    const double spread = 0.5 * e.mean_square_error_deviation / e.mean_square_error;
    const double factor = std::exp(normal_quantile(0.975) * spread);
    return {error / factor, error * factor};
}

std::string image_hash(const Estimate& picture) {
    Sha256 sum;
    sum.add(picture.rgb.data(), picture.rgb.size() * sizeof(float));
    return sum.hex();
}

std::string error_text(const Estimate& picture) {
    if (!picture.relative_standard_error) return "unknown";
    char text[32];
    const double percent = 100 * *picture.relative_standard_error;
    const char* format = percent >= 9.95 ? "%.0f %%" : percent >= 0.995 ? "%.1f %%" : "%.2g %%";
    std::snprintf(text, sizeof text, format, percent);
    return text;
}

}  // namespace lobe
