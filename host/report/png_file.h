// SPDX-License-Identifier: Apache-2.0
// PNG files: 8 bits a channel, sRGB; grey, RGB, each with or without alpha.
#pragma once

#include <string>

#include "report/image_file.h"

namespace lobe {

// The bytes of the file. Throws std::runtime_error with the library's reason.
std::string to_png(const ImageFile& image);
// The same back, without names of channels other than R, G, B and A or Y and A.
ImageFile from_png(const std::string& bytes);

}  // namespace lobe
