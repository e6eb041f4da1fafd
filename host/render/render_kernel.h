// SPDX-License-Identifier: Apache-2.0
// The kernel of a scene, ready to be launched. It can be made while the scene's hierarchies still
// are: it depends on what the scene needs, not on its shapes.
#pragma once

#include <array>

#include "build/pack.h"
#include "cl/program.h"

namespace lobe {

class KernelText;

struct KernelOptions {
    bool double_precision = false;        // the oracle build
    std::array<unsigned, 2> local{8, 8};  // work-group: any gives the same bits
    unsigned abreast = 0;  // samples that a work-item takes side by side, 1 or 8 with the same
                           // bits; 0: what suits the device
};

struct RenderKernel {
    // Builds it and launches it once, empty: runtimes that make the native code late, as PoCL does,
    // make it then. Throws Error (device).
    RenderKernel(const Device& device, const KernelText& kernels, const KernelNeeds& needs,
                 const KernelOptions& options = {});

    Program program;
    cl::Kernel render;
    std::array<unsigned, 2> local;  // as asked for, or less where the device allows less
    double seconds;                 // all of it took
};

}  // namespace lobe
