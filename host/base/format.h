// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lobe {

// What printf would print.
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
std::string
formatted(const char* format, ...);

}  // namespace lobe
