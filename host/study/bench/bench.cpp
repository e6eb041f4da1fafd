// SPDX-License-Identifier: Apache-2.0
#include "study/bench/bench.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"

namespace lobe {

std::optional<BenchScene> bench_scene(const Device& device, const KernelText& kernels, Arm& arm,
                                      const BenchPlan& plan, const std::function<bool()>& stop) {
    BenchScene b;
    const PackedScene& packed = arm.packed();
    b.name = arm.name();
    b.content_hash = arm.content_hash();
    b.width = arm.width();
    b.height = arm.height();
    b.samples = plan.samples;
    b.triangles = packed.triangles.size();
    b.spheres = packed.spheres.size();
    b.lights = packed.lights.lights.size();
    b.device_bytes = arm.device_bytes();
    b.start_up = arm.start_up();

    const double all = double(b.width) * b.height * b.samples;
    std::vector<double> rates, seconds;
    double squares = 0;
    for (unsigned i = 0; i <= plan.repeats; ++i) {
        const ArmRun run = arm.run(i, plan.samples, stop);
        if (run.stopped) return {};
        if (i == 0) continue;
        if (i == 1) b.image_hash = image_hash(run.picture);
        rates.push_back(all / run.seconds);
        seconds.push_back(run.seconds);
        squares += std::pow(run.picture.relative_standard_error.value_or(NAN), 2) / plan.repeats;
    }
    b.rate = median(rates);
    b.rate_deviation = deviation_from(rates, b.rate);
    b.relative_error = std::sqrt(squares);
    b.target_seconds = median(seconds) * squares / (plan.target * plan.target);
    arm.keep_program();
    b.compile_cold = arm.compile_again(Caches::none);
    b.compile_warm = arm.compile_again(Caches::all);
    b.rays = measure_rays(device, kernels, packed, plan.rays, stop);
    return b;
}

}  // namespace lobe
