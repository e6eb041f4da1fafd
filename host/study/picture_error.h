// SPDX-License-Identifier: Apache-2.0
// The error of one render as an experiment counts it.
#pragma once

#include <vector>

#include "study/reference.h"

namespace lobe {

// Mean squared errors of the luminance over the pixels not masked, with the reference's own
// variance subtracted pixel by pixel, over the square of the reference's mean luminance there. Not
// clipped: below zero where the picture is as near to the truth as the reference is.
struct PictureError {
    double mse = 0;
    double mse_trimmed = 0;    // without the 0.1 % of the pixels (at least one) with the largest
    double trimmed_share = 0;  // of the sum of squared errors, in the pixels left out
};

// Zeros where all is masked or the reference is black. `masked` has an entry a pixel.
PictureError picture_error(const Estimate& picture, const Reference& reference,
                           const std::vector<bool>& masked);

// Mean variance of the reference over the pixels not masked, on the same scale as above.
double reference_variance(const Reference& reference, const std::vector<bool>& masked);

}  // namespace lobe
