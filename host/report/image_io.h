// SPDX-License-Identifier: Apache-2.0
// Picture files. Writing takes the formats' own libraries; reading what others may have written,
// and drawing text, the image module, whose libraries take 0.2 s to load.
#pragma once

#include <memory>
#include <string>

#include "report/image_file.h"

namespace lobe {

class ImageIo {
  public:
    ImageIo();
    ~ImageIo();

    // Writes to a temporary name in the same folder, reads it back, compares every value, and only
    // then renames. The format follows the ending. May be called from several threads at once.
    // Throws Error (output).
    void write(const std::string& path, const ImageFile& image);

    // The bytes of a PNG file. Throws Error (output).
    std::string png(const ImageFile& image);

    // Throws Error (scene) if the file cannot be read.
    ImageFile read(const std::string& path);

    // Paints texts, whose unit is the pixel, on an image of three channels, each with a white rim.
    // Throws Error (output) if the font cannot be used.
    void draw_texts(ImageFile& image, const std::string& font, const std::vector<Text>& texts);

  private:
    struct Module;
    const Module& module();
    std::unique_ptr<const Module> module_;
};

// "exr" or "png" by the ending of a path; throws Error (usage) for another, naming these.
std::string image_format(const std::string& path);

}  // namespace lobe
