// SPDX-License-Identifier: Apache-2.0
// A picture as it lies in a file, and the functions of the module that knows file formats and
// fonts.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "report/drawing.h"

namespace lobe {

struct ImageFile {
    std::uint32_t width = 0, height = 0;            // of the data
    std::uint32_t x = 0, y = 0;                     // its corner within the full frame
    std::uint32_t full_width = 0, full_height = 0;  // of the frame
    std::vector<std::string> channels;
    std::vector<float> pixels;  // channel-interleaved rows; 0..255 whole numbers if `bytes`
    bool bytes = false;         // 8 bits a channel, else float32
    std::map<std::string, std::variant<int, double, std::string>> attributes;
};

// The module's functions; `error` stays empty or says what went wrong.
extern "C" {
using ReadImage = void (*)(const char* path, ImageFile& image, std::string& error);
// Paints texts, whose unit is here the pixel, in the font of a file.
using DrawTexts = void (*)(ImageFile& image, const char* font, const std::vector<Text>& texts,
                           std::string& error);
}

}  // namespace lobe
