// SPDX-License-Identifier: Apache-2.0
// The picture and how far it can be trusted, from the film's independent replicates.
#pragma once

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
    std::uint64_t samples = 0;           // per pixel
    unsigned replicates = 0;             // that hold samples

    double image_mean = 0;  // luminance, over all pixels
    std::optional<double> image_mean_standard_error;

    // Over the pixels in which no sample saw a light directly: a light's own edge says nothing
    // about the picture's quality and would outweigh everything else.
    std::size_t masked = 0;                         // pixels left out
    double mean = 0;                                // luminance
    std::optional<double> mean_standard_error;      // of that mean
    std::optional<double> relative_standard_error;  // sqrt(mean squared standard error) / mean
};

Estimate estimate(const Film& film);

// SHA-256 of the float32 rows R, G, B.
std::string image_hash(const Estimate& picture);

// "1.9 %", or "unknown" with fewer than two filled replicates.
std::string error_text(const Estimate& picture);

}  // namespace lobe
