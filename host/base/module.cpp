// SPDX-License-Identifier: Apache-2.0
#include "base/module.h"

#include <dlfcn.h>

#include <filesystem>

namespace lobe {

Module::Module(const std::string& name) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    for (const auto& folder : {program, program / "../lib/lobe"}) {
        handle_ = dlopen((folder / name).c_str(), RTLD_NOW | RTLD_LOCAL);
        if (handle_) return;
        // That a file is not there says less than why one could not be opened.
        if (error_.empty() || std::filesystem::exists(folder / name)) error_ = dlerror();
    }
    handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_) error_.clear();
}

void* Module::find(const char* name) const { return handle_ ? dlsym(handle_, name) : nullptr; }

}  // namespace lobe
