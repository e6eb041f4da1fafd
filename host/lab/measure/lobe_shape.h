// SPDX-License-Identifier: Apache-2.0
// The lobe that a model has about the mirror direction at normal incidence, where it is whole:
// measured on the device's values, whatever the model.
#pragma once

#include <vector>

#include "lab/brdf_probe.h"

namespace lobe {

// g is the lobe over its peak: (f - base) / (peak - base), base the least value of f. Quantities
// are NaN where there is none: g does not fall to half, or nothing rises at the normal.
struct LobeShape {
    double peak, base;  // 1/sr
    double curvature;   // -g'' at the peak, per radian squared: n of cos^n
    double half_width;  // angle at which g = 1/2, radians
    double integral;    // of g over the hemisphere's solid angle, sr
    double albedo;      // of g times the cosine, over the same
    double median;      // angle within which half of the integral lies, radians
};

// For each of the probe's first `sets` parameter sets. Curvature and widths are those in the plane
// of azimuth 0; the integrals go all round.
std::vector<LobeShape> measure_lobe_shapes(const BrdfProbe& probe, std::uint32_t sets);

}  // namespace lobe
