// SPDX-License-Identifier: Apache-2.0
// Options of every verb that reads a scene, and what they change in it.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/kernel_text.h"
#include "build/integrator.h"
#include "scene/scene.h"

namespace lobe {

struct SceneOptions {
    std::string path;
    std::string resolution, crop, filter, dialect = "auto", features = "auto";
    std::vector<std::string> brdfs, replace;
    std::optional<double> replace_n;
    std::optional<std::uint32_t> spp, max_depth;
    bool lenient = false, trust_scene_kernels = false;
    Integrator integrator;
};

void add_scene_options(CLI::App& verb, SceneOptions& options);

// The scene file as the options want it. Models of the user's own, named by --brdf or by the scene,
// are added to the kernels: read_brdf_tables() has them all afterwards. Nothing of them is run.
// Throws Error (usage) for an option that makes no sense.
Scene read_scene_for(const SceneOptions& options, KernelText& kernels);

}  // namespace lobe
