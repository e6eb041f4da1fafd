// SPDX-License-Identifier: Apache-2.0
#include "app/own_scenes.h"

#include <filesystem>

#include "base/error.h"

namespace lobe {

std::string own_scene(const std::string& name) {
    namespace fs = std::filesystem;
    const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
    const fs::path installed = (program / "../share/lobe/scenes" / name).lexically_normal();
    const fs::path source = fs::path(LOBE_SCENES) / name;
    for (const fs::path& file : {installed, source})
        if (fs::exists(file)) return file.string();
    throw Error(
        ExitCode::scene, "lobe's own scene '" + name + "' is not installed", "",
        "it is neither " + installed.string() + " nor " + source.string() + "; give a SCENE");
}

}  // namespace lobe
