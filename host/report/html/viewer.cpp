// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/error.h"
#include "report/html/base64.h"
#include "report/html/parts.h"
#include "report/html/rgbe.h"
#include "report/image_io.h"
#include "report/markup.h"
#include "report/picture.h"

namespace lobe {
namespace {

constexpr std::uint32_t least_shown = 480;  // screen pixels across: smaller pictures are enlarged

// The first three channels; refuses what has other ones there.
std::vector<float> colours(const ReportPicture& picture) {
    const ImageFile& image = picture.image;
    const std::size_t channels = image.channels.size();
    const std::size_t pixels = std::size_t(image.width) * image.height;
    if (channels < 3 || image.channels[0] != "R" || image.channels[1] != "G" ||
        image.channels[2] != "B" || image.pixels.size() != channels * pixels)
        throw Error(ExitCode::internal, "a picture of the report lacks R, G, B", picture.name);
    if (channels == 3) return image.pixels;
    std::vector<float> rgb(3 * pixels);
    for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = image.pixels[i / 3 * channels + i % 3];
    return rgb;
}

// As a page without scripts shows it.
ImageFile shown(const ReportPicture& picture, std::vector<float> rgb, double exposure) {
    ImageFile out;
    out.width = out.full_width = picture.image.width;
    out.height = out.full_height = picture.image.height;
    out.channels = {"R", "G", "B"};
    out.bytes = true;
    out.pixels = std::move(rgb);
    if (!picture.image.bytes)
        for (float& value : out.pixels)
            value = static_cast<float>(std::floor(255 * srgb_encode(exposure * value) + 0.5));
    return out;
}

// The linear values, 4 bytes a pixel.
std::string linear_bytes(const std::vector<float>& rgb) {
    std::string bytes;
    bytes.reserve(rgb.size() / 3 * 4);
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
        for (const std::uint8_t byte : rgbe(&rgb[i])) bytes += static_cast<char>(byte);
    return bytes;
}

std::string picture_html(const ReportPicture& picture, double exposure, ImageIo& images) {
    const std::vector<float> rgb = colours(picture);
    const std::uint32_t width = picture.image.width, height = picture.image.height;
    const std::uint32_t zoom = width < least_shown ? (least_shown + width - 1) / width : 1;
    std::string out = "<figure class=\"picture\"><figcaption>" + markup_text(picture.name) +
                      "</figcaption><img alt=\"" + markup_text(picture.name) + "\" width=\"" +
                      std::to_string(width) + "\" height=\"" + std::to_string(height) +
                      "\" style=\"width:" + std::to_string(zoom * width) + "px\" src=\"" +
                      data_uri("image/png", images.png(shown(picture, rgb, exposure))) + "\"";
    if (!picture.image.bytes) out += " data-linear=\"" + base64(linear_bytes(rgb)) + "\"";
    out += ">";
    if (!picture.note.empty()) out += "<p class=\"note\">" + markup_text(picture.note) + "</p>";
    return out + "</figure>\n";
}

}  // namespace

std::string viewer_html(const ReportViewer& viewer, ImageIo& images) {
    if (viewer.pictures.empty()) return "";
    const ImageFile& first = viewer.pictures[0].image;
    std::string out = "<figure class=\"viewer\" data-stops=\"" +
                      std::to_string(std::log2(viewer.exposure)) + "\">\n<figcaption>" +
                      markup_text(viewer.caption) + "</figcaption>\n<div class=\"pictures\">\n";
    for (const ReportPicture& picture : viewer.pictures) {
        if (picture.image.width != first.width || picture.image.height != first.height)
            throw Error(ExitCode::internal, "the pictures of a viewer differ in size",
                        picture.name);
        out += picture_html(picture, viewer.exposure, images);
    }
    return out + "</div></figure>\n";
}

}  // namespace lobe
