// SPDX-License-Identifier: Apache-2.0
// What a device does with a scene, in figures that can be held against another device's.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cl/device.h"
#include "study/arm.h"
#include "study/bench/growth.h"
#include "study/bench/ray_rates.h"

namespace lobe {

struct BenchPlan {
    std::uint32_t samples = 16;  // a pixel of each timed render
    unsigned repeats = 5;        // of it, each with a seed of its own, after one that warms up
    RayPlan rays;
    double target = 0.01;  // the relative standard error that the time to it is told of
};

struct BenchScene {
    std::string name, content_hash, image_hash;  // the image of the first seed
    std::uint32_t width = 0, height = 0, samples = 0;
    std::size_t triangles = 0, spheres = 0, lights = 0, device_bytes = 0;
    StartUp start_up;
    double compile_cold = 0;    // of a text that no cache knows
    double compile_warm = 0;    // with all that caches can know
    double rate = 0;            // samples a second: median over the repeats
    double rate_deviation = 0;  // of one repeat: 1.4826 times the median absolute deviation
    double relative_error = 0;  // standard error of the picture, root mean square of the repeats'
    double target_seconds = 0;  // to plan.target, as if the error fell with the root of the time
    std::vector<RayRate> rays;
};

struct BenchReport {
    std::string version;
    DeviceInfo device;
    BenchPlan plan;
    std::vector<std::string> command;
    std::vector<BenchScene> scenes;
    std::vector<GrowthSeries> growth;  // if it was asked for
    std::size_t host_bytes = 0;        // most that the process held
};

// Times a scene. Nothing if `stop` said so before there was a figure. Throws Error (device).
std::optional<BenchScene> bench_scene(const Device& device, const KernelText& kernels, Arm& arm,
                                      const BenchPlan& plan,
                                      const std::function<bool()>& stop = {});

}  // namespace lobe
