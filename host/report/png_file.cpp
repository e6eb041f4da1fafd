// SPDX-License-Identifier: Apache-2.0
#include "report/png_file.h"

#include <png.h>

#include <stdexcept>

namespace lobe {
namespace {

constexpr png_uint_32 formats[] = {PNG_FORMAT_GRAY, PNG_FORMAT_GA, PNG_FORMAT_RGB, PNG_FORMAT_RGBA};
const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};

png_image no_image() {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    return image;
}

}  // namespace

std::string to_png(const ImageFile& image) {
    const std::size_t channels = image.channels.size();
    if (!image.bytes || channels < 1 || channels > 4)
        throw std::runtime_error("PNG has one to four channels of bytes");
    png_image png = no_image();
    png.width = image.width;
    png.height = image.height;
    png.format = formats[channels - 1];
    png.flags = PNG_IMAGE_FLAG_FAST;
    const std::vector<unsigned char> pixels(image.pixels.begin(), image.pixels.end());
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png, &bytes[0], &size, 0, pixels.data(), 0, nullptr))
        throw std::runtime_error(png.message);
    bytes.resize(size);
    return bytes;
}

ImageFile from_png(const std::string& bytes) {
    png_image png = no_image();
    if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
        throw std::runtime_error(png.message);
    png.format &= PNG_FORMAT_FLAG_COLOR | PNG_FORMAT_FLAG_ALPHA;  // 8 bits, no palette
    ImageFile image;
    image.width = image.full_width = png.width;
    image.height = image.full_height = png.height;
    image.bytes = true;
    image.channels = names[PNG_IMAGE_SAMPLE_CHANNELS(png.format) - 1];
    std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr))
        throw std::runtime_error(png.message);
    image.pixels.assign(pixels.begin(), pixels.end());
    return image;
}

}  // namespace lobe
