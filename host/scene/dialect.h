// SPDX-License-Identifier: Apache-2.0
// Which version of pbrt a scene is written for.
#pragma once

#include "scene/scene.h"
#include "scene/scene_files.h"

namespace lobe {

// The dialect that the directives, classes and parameters of all files show; a file that shows
// neither is version 4 unless it has a WorldEnd. Throws Error (scene), naming the option
// `--dialect`, for a scene that shows both.
Dialect find_dialect(const SceneFiles& files);

}  // namespace lobe
