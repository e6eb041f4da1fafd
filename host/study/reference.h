// SPDX-License-Identifier: Apache-2.0
// Long renders that errors are measured against: with their own error, kept between runs.
#pragma once

#include <optional>

#include "study/arm.h"

namespace lobe {

class ImageIo;

// A picture near the truth, and how near.
struct Reference {
    std::uint32_t width = 0, height = 0, samples = 0;
    std::uint64_t seed = 0;
    std::vector<float> rgb;              // 3 a pixel
    std::vector<float> standard_error;   // 3 a pixel
    std::vector<float> luminance_error;  // standard error of the luminance, 1 a pixel
    // Pixels that errors leave out: those in which a light is seen directly, and their neighbours,
    // in which a run may hit a sliver of it that the reference missed. A file of reference_of()
    // holds them without the neighbours.
    std::vector<bool> masked;
    bool has_mask = true;  // whether that is known; else none is masked
    bool from_cache = false;
    double seconds = 0;  // of rendering it, now or when it was kept; 0 of a file from elsewhere
    std::string file;    // where it is kept; "" if nowhere
};

// References alone have seeds with this bit: experiments keep their seeds below it, so that no
// experiment shares random numbers with what it is measured against.
constexpr std::uint64_t reference_seed_bit = std::uint64_t{1} << 63;

// The reference of an arm with at least so many samples: from the cache folder, by the arm's
// content hash, or rendered now and kept there. It is always rendered with the default integrator,
// for that is the least noisy and the expectation is the same; so arms that differ in nothing else
// share it. Whole blocks of samples. Nothing is kept where there is no cache folder; a file that is
// damaged or not ours is told of and rendered anew. Shows its own progress. Nothing is returned,
// and nothing kept, if `stop` said so. Throws Error as Arm's constructor and Arm::run.
std::optional<Reference> reference_of(const Device& device, const KernelText& kernels,
                                      const Arm& arm, std::uint32_t samples, ImageIo& images,
                                      const std::function<bool()>& stop = {});

// A reference of the user's own: a picture with R, G, B and, where known, StdError.R, .G, .B and
// Mask, which is widened. What it does not say is taken to be exact and unmasked. Throws Error
// (scene) unless it has this size.
Reference read_reference(const std::string& path, std::uint32_t width, std::uint32_t height,
                         ImageIo& images);

// The mask with all pixels next to one, also at a corner. Row by row, `width` wide.
std::vector<bool> widened(const std::vector<bool>& mask, std::uint32_t width);

}  // namespace lobe
