// SPDX-License-Identifier: Apache-2.0
// The table of kernel sources that the build makes.
#pragma once

#include <cstddef>

namespace lobe {

struct EmbeddedFile {
    const char* path;
    const char* text;
};
extern const EmbeddedFile embedded_files[];
extern const std::size_t embedded_file_count;

}  // namespace lobe
