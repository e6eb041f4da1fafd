// SPDX-License-Identifier: Apache-2.0
// The paper's experiment: every setting rendered with every sampler and many seeds, in turn, each
// measured against the setting's own reference.
#pragma once

#include "cl/device.h"
#include "study/paper/setting.h"
#include "study/picture_error.h"
#include "study/verdict.h"

namespace lobe {

struct PaperSampler {
    const char* name;
    const char* meaning;
    Integrator integrator;
};
// cosine, matched, best.
extern const std::array<PaperSampler, 3> paper_samplers;
constexpr std::size_t cosine_sampler = 0, best_sampler = 2;

struct PaperPlan {
    std::uint32_t samples = 8, runs = 10, reference_samples = 256;
    std::uint64_t first_seed = 1;
    bool keep_pictures = false;  // those of the first seed
};

struct PaperRun {
    std::uint64_t seed = 0;
    double seconds = 0;
    PictureError error;
    double absolute = 0;  // mean over unmasked pixels and channels of |I - R|, in radiance
};

// A setting with a sampler.
struct PaperCell {
    StartUp start_up;
    std::vector<PaperRun> runs;
    std::vector<float> picture;  // R, G, B of the first seed, if kept
};

// A setting and what all its cells share.
struct PaperSetting {
    ModelSetting setting;
    Reference reference;
    double mean = 0;      // luminance of the reference over the pixels not masked
    double variance = 0;  // of the reference, on the scale of PictureError::mse
    std::array<PaperCell, 3> cells;
    FeatureSet features;              // of its kernels
    std::vector<std::string> models;  // that they hold
};

struct PaperExperiment {
    std::vector<PaperSetting> settings;  // in the order of paper_settings()
    std::vector<Wearer> wearers;
    std::uint32_t width = 0, height = 0;
    // Pixels left out of all: those in which a reference sees a light, and their neighbours, in
    // which a run may hit a sliver of it that the reference missed.
    std::size_t masked = 0;
    std::size_t stray = 0;   // pixels of all runs that are not masked and yet saw a light
    std::size_t rounds = 0;  // complete: one run of every cell each
    bool stopped = false;
    double reference_seconds = 0, run_seconds = 0;  // wall clock
};

// Where the kernel, the tables of the models and the scene come from.
struct PaperBench {
    const Device& device;
    const KernelText& kernels;
    const std::vector<BrdfTable>& models;
    const Scene& scene;
    double parse_seconds;
    ImageIo& images;
};

// Runs it. Rounds go over the cells there and back, so that a machine that grows slower is shared
// by all; each cell renders one sample before the first, so that no launch is the first of its
// kind. A round that was stopped is left out. Shows its progress. Throws Error as Arm::run.
PaperExperiment run_paper(const PaperBench& bench, const PaperPlan& plan,
                          const std::vector<Wearer>& wearers,
                          const std::vector<ModelSetting>& settings,
                          const std::function<bool()>& stop = {});

}  // namespace lobe
