// SPDX-License-Identifier: Apache-2.0
// The experiment of `lobe converge`: independent renders over doubling sample counts against one
// reference, and what they say of error, bias and time. Errors are of luminance, over the pixels
// that are not masked.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/bootstrap.h"
#include "base/regression.h"
#include "base/tail_index.h"
#include "cl/device.h"
#include "study/reference.h"

namespace lobe {

struct ConvergencePlan {
    std::uint32_t first = 4;       // samples a pixel of the first level; each has twice the last's
    unsigned levels = 8;           // at least 2
    unsigned seeds = 16;           // renders of each level, at least 3
    std::uint64_t first_seed = 0;  // render i of level k has seed first_seed + 64 i + k
    bool mask = true;              // leave out the pixels that the reference masks
    double target = 0.01;          // the relative error that the time to it is told of
    unsigned resamples = 10000;    // of the bootstrap

    std::uint32_t samples(unsigned level) const { return first << level; }
    double all_samples() const;  // of all renders
    // Of the reference, unless the user has a wish: what brings its variance to a hundredth of the
    // last level's, but no more than all renders together.
    std::uint32_t reference_samples() const;
};

struct ConvergenceRun {
    std::uint64_t seed = 0;
    unsigned level = 0;
    std::uint32_t samples = 0;  // a pixel
    double seconds = 0;
    double mse = 0;               // the reference's variance subtracted; may be below zero
    std::array<double, 3> rgb{};  // the same of R, G, B
    double mse0 = 0;              // the picture's own variance, from its replicates alone
    double bias_squared = 0;      // mse - mse0
    double mse_trimmed = 0;       // without the 0.1 % of the pixels with the largest error
    double relmse = 0, relmse_trimmed = 0, smape = 0, p99 = 0, max = 0;
    std::uint32_t nonfinite = 0, negative = 0;  // samples
    std::string hash;                           // of the picture
};

// All renders of one sample count. A Studentised is a value and its standard error.
struct ConvergenceLevel {
    std::uint32_t samples = 0;
    double seconds = 0;            // median
    double seconds_deviation = 0;  // of one render: 1.4826 times the median absolute deviation
    Studentised mse, mse0, relmse;
    Interval mse_band;  // 95 %, bootstrap over seeds
    double mse_trimmed = 0, relmse_trimmed = 0, smape = 0;
    // Of the mean picture of all seeds: its squared difference from the reference less the variance
    // of both, and its difference; standard errors from the spread over pixels and over seeds.
    Studentised bias_squared, mean_difference;
    double efficiency = 0;  // 1 / (mse * seconds)
};

// What the levels say together. NaN where they cannot: no noise, or none above the reference's.
struct ConvergenceFit {
    LineFit power;  // log of the root of mse over log of samples: the slope is -1/2 for independent
                    // samples
    LineFit floor;  // mse over 1 / samples: the slope is v, the variance of a sample, the
                    // intercept b2, the part of the error that stays
    double b2_error = 0;                            // with what the reference's own error adds
    double b2_p = 1;                                // that b2 is 0, if mse goes as v / N
    Interval slope_band, v_band, b2_band;           // 95 %, bootstrap over seeds
    double seconds_per_sample = 0, overhead = 0;    // Theil-Sen line of seconds over samples
    double unit_variance_seconds = 0;               // v times seconds_per_sample
    Interval unit_variance_band;                    // 95 %, bootstrap over seeds
    double target_samples = 0, target_seconds = 0;  // for the target, along the power law
};

struct ConvergenceReport {
    std::string path, content_hash;
    DeviceInfo device;
    Integrator integrator;
    ConvergencePlan plan;
    std::uint32_t width = 0, height = 0;
    std::size_t masked = 0;  // pixels left out
    std::size_t triangles = 0, spheres = 0, lights = 0;
    FeatureSet features;
    std::vector<std::string> models;
    StartUp start_up;
    double compile_again = 0;            // the second time, with what the first left in caches
    std::optional<double> compile_cold;  // of a text that no cache knows, where measured
    Reference reference;
    double reference_mean = 0;      // luminance
    double reference_variance = 0;  // mean squared standard error of its luminance
    double relmse_epsilon = 0;
    std::vector<ConvergenceRun> runs;      // of the seeds whose renders are complete
    std::vector<ConvergenceLevel> levels;  // empty with fewer than three of those
    ConvergenceFit fit;
    std::optional<TailIndex> tail;  // of the first level's errors, each over its pixel's own
    std::vector<std::string> warnings;
    unsigned seeds = 0;    // complete
    bool stopped = false;  // before all were
};

// Renders and measures. The report has all that the arm, the reference and the renders tell; the
// device and the other compile times are the caller's to fill in. The renders go up and down the
// levels, so that a drifting clock or load hurts all alike. `stop` is asked before every launch.
ConvergenceReport measure_convergence(Arm& arm, const Reference& reference,
                                      const ConvergencePlan& plan,
                                      const std::function<bool()>& stop = {});

// The relative error of a mean squared one: its root over the mean of the reference.
double relative_error(const ConvergenceReport& report, double mse);

}  // namespace lobe
