// SPDX-License-Identifier: Apache-2.0
// The picture and how far it can be trusted, from the film's independent replicates.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/film.h"

namespace lobe {

struct Estimate {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgb;              // 3 a pixel
    std::vector<float> standard_error;   // 3 a pixel, of rgb; empty while unknown
    std::vector<float> luminance_error;  // standard error of the luminance; empty while unknown
    std::vector<bool> sees_light;        // pixels in which some sample saw a light directly
    std::vector<std::uint32_t> sample_counts;  // of each pixel
    std::uint32_t samples = 0;                 // that every pixel has at least
    double mean_samples = 0;                   // per pixel
    unsigned replicates = 0;                   // that hold samples

    double image_mean = 0;  // luminance, over all pixels
    std::optional<double> image_mean_standard_error;
    double image_mean_freedom = 0;  // degrees of freedom of that error, see below

    // Over the pixels in which no sample saw a light directly: a light's own edge says nothing
    // about the picture's quality and would outweigh everything else.
    std::size_t masked = 0;                     // pixels left out
    double mean = 0;                            // luminance
    std::optional<double> mean_standard_error;  // of that mean
    // Effective degrees of freedom of that error (F. Satterthwaite, 1946), estimated: a few where a
    // few noisy pixels make most of it. Intervals of the mean are Student's with so many.
    double mean_freedom = 0;
    std::optional<double> relative_standard_error;  // sqrt(mean_square_error) / mean
    // Mean over those pixels of the squared standard error of luminance, and the standard deviation
    // of that mean: an upper estimate, from the squares' own squares.
    double mean_square_error = 0, mean_square_error_deviation = 0;
};

Estimate estimate(const Film& film);

// What the relative standard error is below with so much confidence (0.95, say); infinity while it
// is unknown.
double relative_error_bound(const Estimate& picture, double confidence);

// 95 % interval of the relative standard error, which is itself an estimate: on its logarithm. Both
// NaN while it is unknown.
std::array<double, 2> relative_error_interval(const Estimate& picture);

// SHA-256 of the float32 rows R, G, B.
std::string image_hash(const Estimate& picture);

// "1.9 %", or "unknown" with fewer than two filled replicates.
std::string error_text(const Estimate& picture);

}  // namespace lobe
