// SPDX-License-Identifier: Apache-2.0
// How many rays a second a device traces in a scene, by the kind of ray.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/kernel_text.h"
#include "build/pack.h"
#include "cl/device.h"

namespace lobe {

struct RayRate {
    std::string name;  // "camera", "camera, eight together", "shadow", "bounce", "second bounce"
    std::size_t rays = 0;
    double met = 0;             // part of them that met something
    double rate = 0;            // rays a second: median over the repeats
    double rate_deviation = 0;  // of one repeat: 1.4826 times the median absolute deviation
};

struct RayPlan {
    std::size_t rays = std::size_t{1} << 20;  // of the camera; the others are fewer
    unsigned repeats = 9;                     // of each kind, in turn, after one that warms up
};

// Shadow rays are there only if the scene has lights. Throws Error (device). Stops early, with the
// kinds measured so far, if `stop` says so.
std::vector<RayRate> measure_rays(const Device& device, const KernelText& kernels,
                                  const PackedScene& scene, const RayPlan& plan = {},
                                  const std::function<bool()>& stop = {});

}  // namespace lobe
