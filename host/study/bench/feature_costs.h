// SPDX-License-Identifier: Apache-2.0
// What the parts of the kernel that a scene does not need would cost it, if they were compiled in.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cl/device.h"
#include "study/arm.h"
#include "study/verdict.h"

namespace lobe {

struct CostPlan {
    std::uint32_t samples = 16;  // a pixel of each timed render
    unsigned repeats = 10;       // of it with each kernel, a seed each, beside the scene's own
    unsigned compiles = 3;       // of each kernel, by no cache's help
};

// A kernel that has more in it than the scene needs.
struct KernelVariant {
    std::string name;  // of what it has more: "THIN_LENS"
    PackOptions pack;
};

// One for each feature that the scene does without, one with all models, one with everything; none
// that would be the scene's own kernel, or the same as another.
std::vector<KernelVariant> kernel_variants(const Scene& scene, const PackOptions& own);

struct KernelCost {
    std::string name;
    std::vector<double> compiles;              // seconds, cold
    std::optional<std::size_t> private_bytes;  // of a work-item; nothing: the device does not tell
    std::optional<std::size_t> binary_bytes;
    std::size_t device_bytes = 0;
    std::vector<double> renders;  // seconds
    double timing_noise = 0;      // coefficient of variation, the worse kernel's of the pair
    PairedRatios ratios;          // of the renders, over those with the scene's own kernel
    Judgement render;             // WIN: the scene's own is the faster
};

struct FeatureCosts {
    std::uint32_t width = 0, height = 0;
    std::string image_hash;  // of the first seed, by all kernels
    KernelCost own;          // without renders: they are measured anew beside each of the others
    std::vector<KernelCost> more;
};

// Compiles and renders the scene with its own kernel and, in turn with it, with each variant.
// Nothing if `stop` said so. Shows its progress. Throws Error (comparison) if a picture differs:
// that is a fault of lobe's; else as Arm.
std::optional<FeatureCosts> measure_feature_costs(const Device& device, const KernelText& kernels,
                                                  const Scene& scene, const PackOptions& own,
                                                  const CostPlan& plan,
                                                  const std::function<bool()>& stop = {});

}  // namespace lobe
