// SPDX-License-Identifier: Apache-2.0
#include "base/memory_peak.h"

#include <fstream>
#include <string>

namespace lobe {

std::size_t memory_peak() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind("VmHWM:", 0) == 0) return std::stoull(line.substr(6)) * 1024;
    return 0;
}

void forget_memory_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

}  // namespace lobe
