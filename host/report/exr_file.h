// SPDX-License-Identifier: Apache-2.0
// OpenEXR files, as every render writes them: 32-bit floats, one part, scan lines, not compressed
// (sampled floats are noise in their low bits: zip makes a noisy 700x700 picture 18 % smaller
// in 2.5 times the time).
#pragma once

#include <string>

#include "report/image_file.h"

namespace lobe {

// Throws std::exception, with the library's reason, if it cannot be written or read.
void write_exr(const std::string& path, const ImageFile& image);
// All channels as floats; no attributes.
ImageFile read_exr(const std::string& path);

}  // namespace lobe
