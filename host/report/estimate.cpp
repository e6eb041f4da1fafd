// SPDX-License-Identifier: Apache-2.0
#include "report/estimate.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "base/luminance.h"
#include "base/sha256.h"

namespace lobe {
namespace {

// Samples with index r modulo LOBE_REPLICATES among `samples`.
std::array<double, LOBE_REPLICATES> replicate_sizes(std::uint64_t samples) {
    std::array<double, LOBE_REPLICATES> sizes{};
    for (unsigned r = 0; r < LOBE_REPLICATES; ++r)
        sizes[r] = static_cast<double>((samples + LOBE_REPLICATES - 1 - r) / LOBE_REPLICATES);
    return sizes;
}

// Variance of the mean over all samples, from the replicates' sums of one quantity: the spread of
// their means, weighed by their sizes, over the number of samples.
double variance_of_mean(const std::array<double, LOBE_REPLICATES>& sums,
                        const std::array<double, LOBE_REPLICATES>& sizes, double samples) {
    double total = 0;
    for (double sum : sums) total += sum;
    const double mean = total / samples;
    double spread = 0;
    for (unsigned r = 0; r < LOBE_REPLICATES; ++r) {
        const double difference = sums[r] / sizes[r] - mean;
        spread += sizes[r] * difference * difference;
    }
    return spread / (LOBE_REPLICATES - 1) / samples;
}

}  // namespace

Estimate estimate(const Film& film) {
    const FilmSums sums = film.sums();
    Estimate e;
    e.width = film.width();
    e.height = film.height();
    e.samples = sums.samples;
    e.rgb.assign(film.pixels() * 3, 0.0f);
    if (e.samples == 0) return e;
    const double samples = static_cast<double>(e.samples);
    const auto sizes = replicate_sizes(e.samples);
    for (double size : sizes) e.replicates += size > 0;
    const bool known = film.complete() && e.replicates == LOBE_REPLICATES;
    e.sees_light.resize(film.pixels());
    if (known) e.standard_error.resize(film.pixels() * 3);
    if (known) e.luminance_error.resize(film.pixels());

    double luminance_sum = 0, variance_sum = 0, all_luminance = 0, all_variance = 0;
    for (std::size_t p = 0; p < film.pixels(); ++p) {
        const double* pixel = &sums.radiance[p * LOBE_REPLICATES * 3];
        std::array<double, LOBE_REPLICATES> light{};
        double total[3] = {0, 0, 0};
        for (unsigned r = 0; r < LOBE_REPLICATES; ++r) {
            for (int c = 0; c < 3; ++c) total[c] += pixel[3 * r + c];
            light[r] = luminance(pixel + 3 * r);
        }
        for (int c = 0; c < 3; ++c) e.rgb[3 * p + c] = static_cast<float>(total[c] / samples);
        if (known) {
            for (int c = 0; c < 3; ++c) {
                std::array<double, LOBE_REPLICATES> channel{};
                for (unsigned r = 0; r < LOBE_REPLICATES; ++r) channel[r] = pixel[3 * r + c];
                e.standard_error[3 * p + c] =
                    static_cast<float>(std::sqrt(variance_of_mean(channel, sizes, samples)));
            }
        }
        const double value = luminance(total) / samples;
        const double variance = known ? variance_of_mean(light, sizes, samples) : 0;
        all_luminance += value;
        all_variance += variance;
        if (known) e.luminance_error[p] = static_cast<float>(std::sqrt(variance));
        if (sums.emitters[p] > 0) {
            ++e.masked;
            e.sees_light[p] = true;
            continue;
        }
        luminance_sum += value;
        variance_sum += variance;
    }
    const auto all = static_cast<double>(film.pixels());
    e.image_mean = all_luminance / all;
    if (known) e.image_mean_standard_error = std::sqrt(all_variance) / all;
    const double counted = static_cast<double>(film.pixels() - e.masked);
    if (counted == 0) return e;
    e.mean = luminance_sum / counted;
    if (known) {
        e.mean_standard_error = std::sqrt(variance_sum) / counted;
        if (e.mean > 0) e.relative_standard_error = std::sqrt(variance_sum / counted) / e.mean;
    }
    return e;
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
