// SPDX-License-Identifier: Apache-2.0
#include "report/picture_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "report/picture.h"

namespace lobe {
namespace {

// The system's own reason, which the image library does not tell.
void check_readable(const std::string& path) {
    std::string reason;
    errno = 0;
    if (std::filesystem::is_directory(path))
        reason = std::strerror(EISDIR);
    else if (!std::ifstream(path))
        reason = std::strerror(errno);
    if (!reason.empty()) throw Error(ExitCode::scene, "cannot read the picture: " + reason, path);
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

// The three channels with these names, interleaved; empty unless all are there. Takes the names
// from `left`.
std::vector<float> take_three(const ImageFile& file, const std::string& prefix,
                              std::vector<std::string>& left) {
    const std::vector<std::string>& names = file.channels;
    std::size_t at[3];
    for (std::size_t c = 0; c < 3; ++c) {
        const auto found = std::find(names.begin(), names.end(), prefix + "RGB"[c]);
        if (found == names.end()) return {};
        at[c] = static_cast<std::size_t>(found - names.begin());
    }
    std::vector<float> values;
    values.reserve(file.pixels.size() / names.size() * 3);
    for (std::size_t p = 0; p < file.pixels.size(); p += names.size())
        for (const std::size_t c : at) values.push_back(file.pixels[p + c]);
    for (const std::size_t c : at) left.erase(std::find(left.begin(), left.end(), names[c]));
    return values;
}

bool is_png(const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    return ending == ".png" || ending == ".PNG";
}

}  // namespace

PictureView ReadPicture::view() const {
    return {file.width, file.height, &rgb, &standard_error, nullptr, freedom};
}

std::string ReadPicture::size_text() const {
    const auto size = [](std::uint32_t w, std::uint32_t h) {
        return std::to_string(w) + "x" + std::to_string(h);
    };
    std::string text = size(file.width, file.height) + " pixels";
    const bool whole = file.width == file.full_width && file.height == file.full_height;
    if (whole && file.x == 0 && file.y == 0) return text;
    return text + " at " + std::to_string(file.x) + "," + std::to_string(file.y) + " of " +
           size(file.full_width, file.full_height);
}

std::string ReadPicture::attribute(const std::string& name) const {
    const auto found = file.attributes.find("lobe:" + name);
    if (found == file.attributes.end()) return "";
    const auto* text = std::get_if<std::string>(&found->second);
    return text ? *text : "";
}

ReadPicture read_picture(ImageIo& images, const std::string& path) {
    check_readable(path);
    ReadPicture picture;
    picture.path = path;
    picture.file = images.read(path);
    ImageFile& file = picture.file;
    picture.other_channels = file.channels;
    picture.rgb = take_three(file, "", picture.other_channels);
    if (picture.rgb.empty())
        throw Error(ExitCode::scene,
                    "the picture has no channels R, G, B but " + listed(file.channels), path,
                    "only colour pictures can be compared");
    picture.standard_error = take_three(file, "StdError.", picture.other_channels);
    picture.from_display = file.bytes || is_png(path);
    if (picture.from_display)
        for (float& v : picture.rgb)
            v = static_cast<float>(srgb_decode(file.bytes ? v / 255.0 : double(v)));
    const std::string replicates = picture.attribute("replicates");
    if (!replicates.empty()) picture.freedom = std::max(1.0, std::atof(replicates.c_str()) - 1);
    file.pixels = {};
    return picture;
}

void check_same_window(const ReadPicture& a, const ReadPicture& b) {
    const ImageFile &x = a.file, &y = b.file;
    bool same = x.width == y.width && x.height == y.height;
    if (!a.from_display && !b.from_display)  // display files know no window
        same = same && x.x == y.x && x.y == y.y && x.full_width == y.full_width &&
               x.full_height == y.full_height;
    if (!same)
        throw Error(ExitCode::scene,
                    "the pictures do not show the same pixels: " + a.size_text() + " against " +
                        b.size_text() + " of " + b.path,
                    a.path, "render both with the same --resolution and --crop");
}

}  // namespace lobe
