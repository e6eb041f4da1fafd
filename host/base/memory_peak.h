// SPDX-License-Identifier: Apache-2.0
// The most memory that the process has held.
#pragma once

#include <cstddef>

namespace lobe {

// Bytes of physical memory, at most at one time since the process began or since
// forget_memory_peak(); 0 where the system does not tell.
std::size_t memory_peak();

// What the process holds now is the peak from now on, where the system can do that (Linux).
void forget_memory_peak();

}  // namespace lobe
