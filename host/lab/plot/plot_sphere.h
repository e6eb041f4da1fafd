// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/image_file.h"

namespace lobe {

class ImageIo;

// A picture and what stands below it.
struct SphereTile {
    std::string title, subtitle;
    ImageFile picture;  // 8 bits, three channels
};

// The tiles, all of one size, in rows of up to four on white.
ImageFile sphere_sheet(const std::vector<SphereTile>& tiles, ImageIo& images);

}  // namespace lobe
