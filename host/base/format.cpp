// SPDX-License-Identifier: Apache-2.0
#include "base/format.h"

#include <cstdarg>
#include <cstdio>

namespace lobe {

std::string formatted(const char* format, ...) {
    va_list values;
    va_start(values, format);
    va_list again;
    va_copy(again, values);
    std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)), '\0');
    va_end(values);
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    return text;
}

}  // namespace lobe
