// SPDX-License-Identifier: Apache-2.0
// Of the 95 % intervals of the image mean, 95 in 100 hold the truth: on scenes from files, with
// both kinds of numbers.
#include <gtest/gtest.h>

#include <cmath>

#include "base/statistics.h"
#include "report/estimate.h"
#include "scene/read.h"
#include "study/arm.h"
#include "support/device.h"
#include "support/probe.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr int seeds = 400;

void expect_coverage(const std::string& file, Integrator::Sampler sampler) {
    const KernelText kernels = test_kernels();
    const std::vector<BrdfTable> models = read_brdf_tables(kernels);
    Scene scene = read_scene(std::string(LOBE_SOURCE_DIR) + "/scenes/" + file, models);
    scene.film.width = scene.film.height = 32;
    PackOptions pack;
    pack.models = models;
    pack.integrator.sampler = sampler;
    Arm arm(file, test_device(), kernels, scene, pack);
    const Estimate truth = arm.run(1u << 30, 8192).picture;
    int held = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        const Estimate e = arm.run(seed, 64).picture;
        const double error =
            std::hypot(*e.image_mean_standard_error, *truth.image_mean_standard_error);
        held += std::abs(e.image_mean - truth.image_mean) <=
                student_quantile(0.975, e.image_mean_freedom) * error;
    }
    std::printf("%s: %d of %d intervals hold the truth\n", file.c_str(), held, seeds);
    EXPECT_GE(held, 0.92 * seeds);
    EXPECT_LE(held, 0.98 * seeds);
}

}  // namespace

TEST(Coverage, CornellSobol) {
    expect_coverage("cornell/cornell.pbrt", Integrator::Sampler::sobol);
}
TEST(Coverage, CornellIndependent) {
    expect_coverage("cornell/cornell.pbrt", Integrator::Sampler::independent);
}
TEST(Coverage, ShowpieceSobol) {
    expect_coverage("showpiece/showpiece.pbrt", Integrator::Sampler::sobol);
}
TEST(Coverage, ShowpieceIndependent) {
    expect_coverage("showpiece/showpiece.pbrt", Integrator::Sampler::independent);
}
