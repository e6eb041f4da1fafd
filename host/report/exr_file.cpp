// SPDX-License-Identifier: Apache-2.0
#include "report/exr_file.h"

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

namespace lobe {
namespace {

Imath::Box2i box(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) {
    const Imath::V2i low(static_cast<int>(x), static_cast<int>(y));
    return {low, low + Imath::V2i(static_cast<int>(width) - 1, static_cast<int>(height) - 1)};
}

Imf::Header header_of(const ImageFile& image) {
    Imf::Header header(box(0, 0, image.full_width, image.full_height),
                       box(image.x, image.y, image.width, image.height));
    header.compression() = Imf::NO_COMPRESSION;
    for (const std::string& name : image.channels)
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    for (const auto& [name, value] : image.attributes) {
        if (const auto* i = std::get_if<int>(&value)) header.insert(name, Imf::IntAttribute(*i));
        if (const auto* d = std::get_if<double>(&value))
            header.insert(name, Imf::FloatAttribute(static_cast<float>(*d)));
        if (const auto* s = std::get_if<std::string>(&value))
            header.insert(name, Imf::StringAttribute(*s));
    }
    return header;
}

// Where the library finds, or puts, the image's pixels.
Imf::FrameBuffer buffer_of(const ImageFile& image) {
    Imf::FrameBuffer buffer;
    const std::size_t pixel = image.channels.size() * sizeof(float), row = pixel * image.width;
    for (std::size_t c = 0; c < image.channels.size(); ++c)
        buffer.insert(image.channels[c],
                      Imf::Slice(Imf::FLOAT,
                                 reinterpret_cast<char*>(const_cast<float*>(&image.pixels[c])) -
                                     image.x * pixel - image.y * row,
                                 pixel, row));
    return buffer;
}

}  // namespace

void write_exr(const std::string& path, const ImageFile& image) {
    Imf::OutputFile file(path.c_str(), header_of(image), 0);
    file.setFrameBuffer(buffer_of(image));
    file.writePixels(static_cast<int>(image.height));
}

ImageFile read_exr(const std::string& path) {
    Imf::InputFile file(path.c_str(), 0);
    const Imf::Header& header = file.header();
    const Imath::Box2i data = header.dataWindow(), full = header.displayWindow();
    ImageFile image;
    image.x = static_cast<std::uint32_t>(data.min.x - full.min.x);
    image.y = static_cast<std::uint32_t>(data.min.y - full.min.y);
    image.width = static_cast<std::uint32_t>(data.max.x - data.min.x + 1);
    image.height = static_cast<std::uint32_t>(data.max.y - data.min.y + 1);
    image.full_width = static_cast<std::uint32_t>(full.max.x - full.min.x + 1);
    image.full_height = static_cast<std::uint32_t>(full.max.y - full.min.y + 1);
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
        image.channels.emplace_back(c.name());
    image.pixels.resize(std::size_t{image.width} * image.height * image.channels.size());
    file.setFrameBuffer(buffer_of(image));
    file.readPixels(data.min.y, data.max.y);
    return image;
}

}  // namespace lobe
