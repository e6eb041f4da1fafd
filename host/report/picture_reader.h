// SPDX-License-Identifier: Apache-2.0
// Picture files as what was computed: linear light with its standard errors.
#pragma once

#include "report/image_io.h"
#include "report/metrics.h"

namespace lobe {

struct ReadPicture {
    std::string path;
    ImageFile file;                        // as it lies there; no pixels
    std::vector<float> rgb;                // 3 a pixel, linear
    std::vector<float> standard_error;     // 3 a pixel; empty if the file has none
    double freedom = LOBE_REPLICATES - 1;  // of the standard errors, as the file says
    bool from_display = false;  // it held sRGB values, clipped and rounded to their few bits
    std::vector<std::string> other_channels;  // not read

    PictureView view() const;
    // "32x24 pixels", and for a window "at 8,12 of 64x48".
    std::string size_text() const;
    // A lobe attribute, or "".
    std::string attribute(const std::string& name) const;
};

// Reads R, G, B and, where there are all three, StdError.R, .G, .B. Whole numbers of 8 bits, and
// any PNG, are sRGB values and become linear. Throws Error (scene) with the path and the reason, or
// for a picture without R, G, B.
ReadPicture read_picture(ImageIo& images, const std::string& path);

// Throws Error (scene) unless both pictures show the same pixels of the same film.
void check_same_window(const ReadPicture& a, const ReadPicture& b);

}  // namespace lobe
