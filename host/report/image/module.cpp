// SPDX-License-Identifier: Apache-2.0
// With text.cpp the only code that knows OpenImageIO. It is a module of its own, opened on demand:
// loading that library costs some 0.2 s and 130 MB, which no render should pay.
#include <OpenImageIO/imageio.h>

#include "report/image_file.h"

using lobe::ImageFile;

extern "C" void lobe_read_image(const char* path, ImageFile& image, std::string& error) {
    auto input = OIIO::ImageInput::open(path);
    if (!input) {
        error = OIIO::geterror();
        return;
    }
    const OIIO::ImageSpec& spec = input->spec();
    image.width = static_cast<std::uint32_t>(spec.width);
    image.height = static_cast<std::uint32_t>(spec.height);
    image.x = static_cast<std::uint32_t>(spec.x);
    image.y = static_cast<std::uint32_t>(spec.y);
    image.full_width = static_cast<std::uint32_t>(spec.full_width);
    image.full_height = static_cast<std::uint32_t>(spec.full_height);
    image.channels = spec.channelnames;
    image.bytes = spec.format == OIIO::TypeDesc::UINT8;
    const std::size_t count = static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels;
    image.pixels.resize(count);
    bool good;
    if (image.bytes) {
        std::vector<unsigned char> bytes(count);
        good = input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, bytes.data());
        image.pixels.assign(bytes.begin(), bytes.end());
    } else {
        good =
            input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data());
    }
    for (const auto& attribute : spec.extra_attribs)
        image.attributes[attribute.name().string()] = attribute.get_string();
    if (!good) error = input->geterror();
}
