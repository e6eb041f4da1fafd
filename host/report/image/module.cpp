// SPDX-License-Identifier: Apache-2.0
// With text.cpp the only code that knows OpenImageIO. It is a module of its own, opened on demand:
// loading that library costs some 0.2 s and 130 MB, which `lobe --help` should not pay.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "report/image_file.h"

namespace {

using lobe::ImageFile;

OIIO::ImageSpec make_spec(const ImageFile& image) {
    OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height),
                         static_cast<int>(image.channels.size()),
                         image.bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.channelnames = image.channels;
    spec.x = static_cast<int>(image.x);
    spec.y = static_cast<int>(image.y);
    spec.full_width = static_cast<int>(image.full_width);
    spec.full_height = static_cast<int>(image.full_height);
    for (const auto& [name, value] : image.attributes) {
        if (const auto* i = std::get_if<int>(&value)) spec.attribute(name, *i);
        if (const auto* d = std::get_if<double>(&value))
            spec.attribute(name, static_cast<float>(*d));
        if (const auto* s = std::get_if<std::string>(&value)) spec.attribute(name, *s);
    }
    spec.attribute("DateTime", "");  // else the same render gives other bytes each time
    // Sampled floats are noise in their low bits: zip makes a noisy 700x700 picture 18 % smaller in
    // 2.5 times the time.
    spec.attribute("compression", "none");
    spec.attribute("png:compressionLevel", 3);
    if (image.bytes) spec.attribute("oiio:ColorSpace", "sRGB");
    return spec;
}

bool put(OIIO::ImageOutput& output, const char* path, const ImageFile& image) {
    bool good = output.open(path, make_spec(image));
    if (good && image.bytes) {
        const std::vector<unsigned char> bytes(image.pixels.begin(), image.pixels.end());
        good = output.write_image(OIIO::TypeDesc::UINT8, bytes.data());
    } else if (good) {
        good = output.write_image(OIIO::TypeDesc::FLOAT, image.pixels.data());
    }
    // Both must succeed: some writers notice a full disk only when they close.
    return output.close() && good;
}

std::string reason(const OIIO::ImageOutput& output) {
    return output.has_error() ? output.geterror() : "writing failed";
}

}  // namespace

extern "C" void lobe_write_image(const char* path, const char* format, const ImageFile& image,
                                 std::string& error) {
    auto output = OIIO::ImageOutput::create(format);
    if (!output) {
        error = OIIO::geterror();
        return;
    }
    if (!put(*output, path, image)) error = reason(*output);
}

extern "C" void lobe_encode_image(const char* format, const ImageFile& image, std::string& bytes,
                                  std::string& error) {
    auto output = OIIO::ImageOutput::create(format);
    std::vector<unsigned char> memory;
    OIIO::Filesystem::IOVecOutput proxy(memory);
    if (!output || !output->set_ioproxy(&proxy)) {
        error = output ? "the format wants a file" : OIIO::geterror();
        return;
    }
    if (!put(*output, "memory", image)) error = reason(*output);
    bytes.assign(memory.begin(), memory.end());
}

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
