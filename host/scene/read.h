// SPDX-License-Identifier: Apache-2.0
// Reads a pbrt scene (version 3 or 4 text) with all files it includes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/brdf_table.h"
#include "scene/scene.h"

namespace lobe {

struct ReadOptions {
    Dialect dialect = Dialect::automatic;
    bool lenient = false;  // unknown directives, types and parameters warn instead of failing
    // `--replace TYPE=MODEL`: materials that the scene file calls TYPE take this model in place of
    // their own. From plastic: kd = Kd / pi, ks = Ks, n = replace_n; from matte: kd = Kd / pi, ks =
    // 0.
    std::vector<std::pair<std::string, std::string>> replace;
    std::optional<double> replace_n;  // wins over the scene's n, or the model's default
};

// Throws Error (scene) with FILE:LINE:COL, the offending value, and the choices or nearest name.
Scene read_scene(const std::string& path, const std::vector<BrdfTable>& models,
                 const ReadOptions& options = {});

}  // namespace lobe
