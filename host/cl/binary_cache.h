// SPDX-License-Identifier: Apache-2.0
// Program binaries of earlier runs, one file each in the user's cache folder. A damaged binary can
// kill the process inside a driver, so each file carries its length and hash and is checked first.
#pragma once

#include <string>

namespace lobe {

class Device;
struct DeviceInfo;
struct Program;

// LOBE_CACHE_DIR, else XDG_CACHE_HOME/lobe, else ~/.cache/lobe; "" if the environment has none.
std::string cache_folder();

// Whether keeping binaries saves time on this device. The environment's LOBE_PROGRAM_CACHE=on|off
// overrides.
bool binary_cache_pays(const DeviceInfo& info);

// Fills program.program with the cached binary of program.key, ready to use; false if there is none
// that can be used. A bad file is removed.
bool load_binary(const Device& device, Program& program, const std::string& build_options);

// Keeps the program's binary for later runs, where that pays and it is not there yet. To be called
// after the render: asking for a binary before the first launch costs a compilation. Never fails:
// a cache that cannot be written is only a slower next start.
void save_binary(const Device& device, const Program& program);

}  // namespace lobe
