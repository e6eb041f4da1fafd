// SPDX-License-Identifier: Apache-2.0
// Reading and writing picture files through the image module.
#pragma once

#include <future>
#include <memory>
#include <string>

#include "report/image_file.h"

namespace lobe {

class ImageIo {
  public:
    ImageIo();
    ~ImageIo();

    // Begins to open the module in the background, for whoever will need it soon; else the first
    // use opens it. While it opens, no other library can be loaded.
    void begin();

    // Writes to a temporary name in the same folder, reads it back, compares every value, and only
    // then renames. The format follows the ending. Throws Error (output).
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
    Module& module();
    std::future<std::unique_ptr<Module>> opening_;
    std::unique_ptr<Module> module_;
};

// "exr" or "png" by the ending of a path; throws Error (usage) for another, naming these.
std::string image_format(const std::string& path);

}  // namespace lobe
