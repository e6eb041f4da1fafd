// SPDX-License-Identifier: Apache-2.0
// The scenes that come with lobe: they are files, not part of the program.
#pragma once

#include <string>

namespace lobe {

// The path of "showpiece/showpiece.pbrt" and the like: in ../share/lobe/scenes (of an installation)
// or in the source folder that the program was built from. Throws Error (scene) if neither has it.
std::string own_scene(const std::string& name);

}  // namespace lobe
