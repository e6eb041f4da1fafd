// SPDX-License-Identifier: Apache-2.0
// How time and memory grow with a scene, its lights, its film and its samples.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/kernel_text.h"
#include "cl/device.h"

namespace lobe {

struct RenderSizes {
    std::size_t triangles = 100000, lights = 1, samples = 16;
    std::size_t film = 256;  // pixels across a square
};

struct GrowthPlan {
    RenderSizes usual;  // of what does not grow
    std::vector<std::size_t> triangles, lights, film, samples;
};
GrowthPlan whole_growth();  // 1k to 10M, 1 to 10k, 256 to 8192, 16 to 1M
GrowthPlan short_growth();  // for slow devices: it shows that all works

// A render of one size, from the scene in memory to the picture in memory.
struct GrowthPoint {
    std::size_t size = 0;
    double build_seconds = 0;       // hierarchies of shapes and lights, and all else made ready
    double render_seconds = 0;      // median of three
    double seconds_per_sample = 0;  // of one pixel
    std::size_t device_bytes = 0;
    std::size_t host_bytes = 0;  // peak of the process; on a CPU the device's are among them
};

struct GrowthSeries {
    std::string what;  // that grows: "triangles"
    std::vector<GrowthPoint> points;
    std::string end;  // why there are no more of them, or ""
};

// One of the sizes grows and the others stay, but that large films take 2 samples a pixel and many
// samples go to 16 by 16 pixels. A size that device or host cannot hold ends its series. What
// `stop` cuts short is left out. Throws Error (device) if nothing can be rendered.
std::vector<GrowthSeries> measure_growth(const Device& device, const KernelText& kernels,
                                         const GrowthPlan& plan,
                                         const std::function<bool()>& stop = {});

}  // namespace lobe
