// SPDX-License-Identifier: Apache-2.0
// From an estimate to picture files: the EXR with its error bars and metadata, the sRGB PNG.
#pragma once

#include "report/estimate.h"
#include "report/image_file.h"
#include "shared/frame.h"

namespace lobe {

// What the EXR's header says of the render. Attributes that other programs know keep their names.
struct PictureFacts {
    std::map<std::string, std::variant<int, double, std::string>> attributes;
    LobeFrame frame{};  // film size and window
};

// Float32 R, G, B and, where known, StdError.R, .G, .B (standard error of each pixel's value; with
// K replicates it has K - 1 degrees of freedom); SampleCount where pixels have unlike numbers. Data
// window = crop, display window = film.
ImageFile float_picture(const Estimate& picture, const PictureFacts& facts);

// 8 bits a channel, sRGB, after multiplication by `exposure`. Cropped to the window.
ImageFile display_picture(const Estimate& picture, double exposure = 1);

// IEC 61966-2-1 encoding of a linear value, clamped to [0, 1]; NaN gives 0.
double srgb_encode(double linear);
double srgb_decode(double display);  // the inverse

}  // namespace lobe
