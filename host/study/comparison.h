// SPDX-License-Identifier: Apache-2.0
// The experiment of `lobe compare`: two arms rendered in turn, with many seeds, to the same number
// of samples and for the same time, and what their errors say.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/picture_error.h"
#include "study/verdict.h"

namespace lobe {

struct ComparisonPlan {
    std::uint32_t seeds = 20;
    std::uint64_t first_seed = 1;
    // Both arms have the same seeds, so that noise that they share is no noise between them. Where
    // they share none, that is as good as seeds of their own, which `own_seeds` gives B: a thing is
    // then compared with itself without being identical.
    bool own_seeds = false;
    std::vector<std::uint32_t> samples = {8, 64};  // a row each at equal samples
    std::vector<double> times = {1, 2, 4, 8};      // a row each at equal time: multiples of a base
    std::uint32_t base_samples = 8;                // the base is what A takes for so many samples,
    double base_seconds = 0;                       // unless it is given
    std::uint32_t reference_samples = 1024;
    unsigned warm_up = 2;  // runs of each arm that do not count
};

struct ComparedRun {
    std::uint64_t seed = 0;
    std::uint32_t samples = 0;  // per pixel
    double seconds = 0;
    PictureError error;
};

// All seeds at one number of samples, or at one time.
struct ComparisonRow {
    bool equal_time = false;
    double aim_seconds = 0;  // of equal time
    std::uint32_t samples_a = 0, samples_b = 0;
    std::vector<ComparedRun> a, b;
    // Of the errors at equal samples; of error times time at equal time, which makes up for what
    // the times still differ.
    PairedRatios ratios, trimmed_ratios;
    Judgement judgement, trimmed;
};

// What an arm was.
struct ComparedArm {
    std::string name, scene, options, integrator, content_hash;
    StartUp start_up;
    FeatureSet features;
    std::vector<std::string> models;
    std::uint32_t nonfinite = 0;          // samples, over all runs
    std::uint32_t reference_samples = 0;  // per pixel
    double reference_variance = 0;        // on the scale of PictureError::mse
    double reference_seconds = 0;
    bool reference_from_cache = false;
    double mean = 0;  // luminance of the reference, over the pixels compared
};

struct SceneComparison {
    ComparedArm a, b;
    bool same_content = false;  // the arms differ in the integrator's choices alone
    std::uint32_t width = 0, height = 0;
    std::size_t masked = 0;  // pixels that either reference masks
    std::vector<ComparisonRow> rows;
};

// One arm of a scene with what it is measured against.
struct MeasuredArm {
    Arm& arm;
    const Reference& reference;
};

// Runs the experiment on one scene: its rows in the order of the plan, equal samples first. The
// judgements are left out: they need all scenes. Nothing if `stop` said so. Shows its progress.
// Throws Error (usage) for films of different sizes, or as Arm::run.
std::optional<SceneComparison> run_comparison(const MeasuredArm& a, const MeasuredArm& b,
                                              const ComparisonPlan& plan,
                                              const std::function<bool()>& stop = {});

// Judges row by row, Holm-adjusted over the scenes, which have the same rows.
void judge_rows(std::vector<SceneComparison>& scenes);

// The even number with three leading bits (2, 4, 6, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40...) that
// is nearest to `wanted` in ratio: Sobol's points are less even at others, and an arm whose time
// suits a power of two should not win by that.
std::uint32_t even_samples(double wanted);

}  // namespace lobe
