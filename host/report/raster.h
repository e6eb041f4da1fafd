// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/drawing.h"
#include "report/image_file.h"

namespace lobe {

class ImageIo;

// The drawing as 8-bit pixels, `scale` of them a unit, on white; edges are smooth. Texts need a
// font of the system; where none is found they are left out, with one warning.
ImageFile rasterise(const Drawing& drawing, ImageIo& images, double scale = 2);

}  // namespace lobe
