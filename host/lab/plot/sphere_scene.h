// SPDX-License-Identifier: Apache-2.0
// A sphere of a model on a chequered floor, under a lamp and a sky: what the model looks like.
#pragma once

#include "lab/settings.h"
#include "render/render.h"
#include "report/estimate.h"

namespace lobe {

struct SpherePlan {
    std::uint32_t pixels = 320;  // across and down
    std::uint32_t samples = 64;  // per pixel
    std::uint64_t seed = 1;
};

struct SpherePicture {
    Estimate picture;
    double seconds = 0;    // of rendering
    bool stopped = false;  // by the caller
};

Scene sphere_scene(const Subject& subject, const std::vector<BrdfTable>& models,
                   std::uint32_t pixels);

// Renders it; `stop` as in render(). Warns of samples that are no numbers or negative.
SpherePicture render_sphere(const Device& device, const KernelText& kernels,
                            const std::vector<BrdfTable>& models, const Subject& subject,
                            const SpherePlan& plan, const std::function<bool()>& stop = {});

}  // namespace lobe
