// SPDX-License-Identifier: Apache-2.0
// What `lobe converge` measures, where the truth is known: independent samples converge as 1/N and
// to the truth, Sobol's faster, and a picture that is .5 % too bright is found out.
#include "study/convergence.h"

#include <cmath>

#include "report/image_io.h"
#include "study/convergence_report.h"
#include "support/device.h"
#include "support/probe.h"
#include "support/scenes.h"
#include "support/temp_folder.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double albedo = 0.5;
constexpr unsigned depth = 3;
const double radiance = (1 - std::pow(albedo, depth + 1)) / (1 - albedo);

// The inside of a sphere that shines everywhere alike.
Scene furnace() {
    Scene scene = small_scene(albedo, 32);
    scene.max_depth = depth;
    shine(add(scene, {0.2, 0.1, -0.1}, 1), 1).flipped = true;
    return scene;
}

// A lit wall and what a ball leaves of the light.
Scene room() {
    Scene scene = small_scene(albedo, 32);
    scene.max_depth = 2;
    add(scene, wall(4, 8));
    add(scene, {0, 0, 3}, .6);
    shine(add(scene, {2, 2, 1}, .3), 40);
    return scene;
}

Arm arm_of(const Scene& scene, Integrator::Sampler sampler) {
    const KernelText kernels = test_kernels();
    PackOptions options;
    options.models = read_brdf_tables(kernels);
    options.integrator.sampler = sampler;
    return Arm("test", test_device(), kernels, scene, options);
}

// A picture of one value, taken to be exact.
Reference flat(double value) {
    Reference reference;
    reference.width = reference.height = 32;
    reference.rgb.assign(3 * 1024, static_cast<float>(value));
    reference.standard_error.assign(3 * 1024, 0);
    reference.luminance_error.assign(1024, 0);
    reference.masked.assign(1024, false);
    return reference;
}

ConvergencePlan plan(unsigned levels) {
    ConvergencePlan plan;
    plan.levels = levels;
    plan.resamples = 1000;
    return plan;
}

// The truth is known without a render: no reference's error, no mask.
ConvergenceReport in_the_furnace(double scale) {
    Arm arm = arm_of(furnace(), Integrator::Sampler::independent);
    return measure_convergence(arm, flat(radiance * scale), plan(7));
}

}  // namespace

TEST(Convergence, IndependentSamplesInTheFurnace) {
    const ConvergenceReport r = in_the_furnace(1);
    ASSERT_EQ(r.levels.size(), 7u);
    EXPECT_NEAR(r.fit.power.slope, -0.5, 0.01);
    EXPECT_LT(r.fit.power.slope_error, 0.005);
    EXPECT_LT(std::fabs(r.fit.floor.intercept), 3 * r.fit.b2_error);
    EXPECT_FALSE(judge_bias(r).found) << judge_bias(r).sentence;
    EXPECT_GT(r.fit.floor.p(), 1e-3) << "MSE goes as v / N";
    for (const ConvergenceLevel& level : r.levels) {
        EXPECT_LT(std::fabs(level.bias_squared.value), 4 * level.bias_squared.error);
        EXPECT_LT(std::fabs(level.mean_difference.value), 4 * level.mean_difference.error);
        // The picture's own estimate of its error, without a reference.
        EXPECT_NEAR(level.mse0.value / level.mse.value, 1, 0.05);
    }
    EXPECT_NE(r.runs[0].hash, r.runs[1].hash);
    ASSERT_TRUE(r.tail);
    EXPECT_FALSE(r.tail->heavy());
}

TEST(Convergence, HalfAPercentIsFound) {
    const ConvergenceReport r = in_the_furnace(1 / 1.005);
    const double bias = radiance - radiance / 1.005;
    EXPECT_NEAR(r.fit.floor.intercept, bias * bias, 4 * r.fit.b2_error);
    EXPECT_GT(r.fit.floor.intercept, 4 * r.fit.b2_error);
    EXPECT_LT(r.fit.b2_p, 1e-3);
    const BiasVerdict verdict = judge_bias(r);
    EXPECT_TRUE(verdict.found) << verdict.sentence;
    EXPECT_GT(verdict.mean_z, 5);
    EXPECT_GT(verdict.squared_z, 5);
    EXPECT_NEAR(r.levels.back().bias_squared.value, bias * bias,
                4 * r.levels.back().bias_squared.error);
}

// Against a rendered reference, whose own error is taken out and told.
TEST(Convergence, SobolIsSteeper) {
    TempFolder folder;
    const ScopedVariable cache("LOBE_CACHE_DIR", folder.path().c_str());
    ImageIo images;
    Arm independent = arm_of(room(), Integrator::Sampler::independent);
    Arm sobol = arm_of(room(), Integrator::Sampler::sobol);
    const ConvergencePlan p = plan(6);
    const auto reference = reference_of(test_device(), test_kernels(), sobol, 4096, images);
    ASSERT_TRUE(reference);
    const ConvergenceReport a = measure_convergence(independent, *reference, p);
    const ConvergenceReport b = measure_convergence(sobol, *reference, p);
    EXPECT_NEAR(a.fit.power.slope, -0.5, 0.01);
    EXPECT_LT(std::fabs(a.fit.floor.intercept), 3 * a.fit.b2_error);
    EXPECT_LT(b.fit.power.slope, -0.52);
    EXPECT_LT(b.levels.back().mse.value, a.levels.back().mse.value);
    EXPECT_FALSE(judge_bias(a).found) << judge_bias(a).sentence;
    EXPECT_FALSE(judge_bias(b).found) << judge_bias(b).sentence;
    EXPECT_GT(a.reference_variance, 0);
}

TEST(Convergence, AStopKeepsWholeSeeds) {
    Arm arm = arm_of(furnace(), Integrator::Sampler::sobol);
    int asked = 0;
    const ConvergenceReport few =
        measure_convergence(arm, flat(radiance), plan(3), [&] { return ++asked > 40; });
    EXPECT_TRUE(few.stopped);
    EXPECT_LT(few.seeds, 16u);
    EXPECT_EQ(few.runs.size(), 3 * few.seeds);
    EXPECT_EQ(few.levels.empty(), few.seeds < 3);
    const ConvergenceReport none =
        measure_convergence(arm, flat(radiance), plan(3), [] { return true; });
    EXPECT_TRUE(none.levels.empty());
    EXPECT_EQ(none.seeds, 0u);
    EXPECT_NE(to_text(none).find("too few"), std::string::npos);
}
