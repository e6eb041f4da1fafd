// SPDX-License-Identifier: Apache-2.0
// Long renders that errors are measured against: with their own error, kept between runs.
#pragma once

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
    std::vector<bool> masked;            // pixels in which a light is seen directly
    bool from_cache = false;
    double seconds = 0;  // of rendering it, when it was rendered
    std::string file;    // where it is kept; "" if nowhere
};

// The reference of an arm with at least so many samples: from the cache folder, by the content of
// the scene, or rendered with a seed that no experiment uses, and kept there. Nothing is kept where
// there is no cache folder. Throws Error as Arm::run; an unreadable file is rendered anew.
// `progress` is told samples done and all samples.
Reference reference_of(Arm& arm, std::uint32_t samples, ImageIo& images,
                       const std::function<bool()>& stop = {});

}  // namespace lobe
