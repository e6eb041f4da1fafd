// SPDX-License-Identifier: Apache-2.0
#include "study/reference_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "base/luminance.h"
#include "base/sha256.h"

namespace lobe {
namespace {

const std::array<const char*, 3> colours = {"R", "G", "B"};
const std::array<const char*, 3> errors = {"StdError.R", "StdError.G", "StdError.B"};
const char* const luminance_error = "StdError.Y";
const char* const mask = "Mask";

std::string checksum(const Reference& r) {
    Sha256 sum;
    for (const auto* values : {&r.rgb, &r.standard_error, &r.luminance_error})
        sum.add(values->data(), values->size() * sizeof(float));
    for (const bool masked : r.masked) sum.add(masked ? "1" : "0");
    return sum.hex();
}

// The named channels, interleaved; nothing if one is missing.
template <std::size_t count>
std::vector<float> channels(const ImageFile& picture, const std::array<const char*, count>& names) {
    const std::size_t stride = picture.channels.size();
    const std::size_t pixels = static_cast<std::size_t>(picture.width) * picture.height;
    std::vector<float> values(pixels * count);
    for (std::size_t c = 0; c < count; ++c) {
        const auto at = std::find(picture.channels.begin(), picture.channels.end(), names[c]);
        if (at == picture.channels.end()) return {};
        const auto from = static_cast<std::size_t>(at - picture.channels.begin());
        for (std::size_t p = 0; p < pixels; ++p)
            values[p * count + c] = picture.pixels[p * stride + from];
    }
    return values;
}

std::string attribute(const ImageFile& picture, const std::string& name) {
    const auto at = picture.attributes.find(name);
    const auto* text =
        at == picture.attributes.end() ? nullptr : std::get_if<std::string>(&at->second);
    return text ? *text : "";
}

Reference read(const ImageFile& picture) {
    Reference r;
    r.width = picture.width;
    r.height = picture.height;
    r.rgb = channels(picture, colours);
    r.standard_error = channels(picture, errors);
    r.luminance_error = channels<1>(picture, {luminance_error});
    for (const float value : channels<1>(picture, {mask})) r.masked.push_back(value != 0);
    r.samples = static_cast<std::uint32_t>(
        std::strtoul(attribute(picture, "samplesPerPixel").c_str(), nullptr, 10));
    r.seed = std::strtoull(attribute(picture, "lobe:seed").c_str(), nullptr, 10);
    r.seconds = std::strtod(attribute(picture, "renderTimeSeconds").c_str(), nullptr);
    return r;
}

}  // namespace

ImageFile reference_picture(const Reference& r, const std::string& content_hash) {
    ImageFile file;
    file.width = file.full_width = r.width;
    file.height = file.full_height = r.height;
    for (const auto& names : {colours, errors})
        file.channels.insert(file.channels.end(), names.begin(), names.end());
    file.channels.insert(file.channels.end(), {luminance_error, mask});
    for (std::size_t p = 0; p < r.masked.size(); ++p) {
        const auto* colour = &r.rgb[3 * p];
        const auto* error = &r.standard_error[3 * p];
        file.pixels.insert(file.pixels.end(), colour, colour + 3);
        file.pixels.insert(file.pixels.end(), error, error + 3);
        file.pixels.push_back(r.luminance_error[p]);
        file.pixels.push_back(r.masked[p] ? 1.0f : 0.0f);
    }
    file.attributes["samplesPerPixel"] = static_cast<int>(r.samples);
    file.attributes["renderTimeSeconds"] = r.seconds;
    file.attributes["lobe:seed"] = std::to_string(r.seed);
    file.attributes["lobe:contentHash"] = content_hash;
    file.attributes["lobe:checksum"] = checksum(r);
    return file;
}

Reference checked_reference(const ImageFile& picture, const std::string& content_hash) {
    Reference r = read(picture);
    if (attribute(picture, "lobe:contentHash") != content_hash)
        throw Error(ExitCode::scene, "it is no reference of this scene");
    if (attribute(picture, "lobe:checksum") != checksum(r) || r.samples == 0)
        throw Error(ExitCode::scene, "its values are not those that were written");
    return r;
}

Reference any_reference(const ImageFile& picture, std::uint32_t width, std::uint32_t height) {
    const auto size = [](std::uint32_t w, std::uint32_t h) {
        return std::to_string(w) + "x" + std::to_string(h);
    };
    if (picture.width != width || picture.height != height)
        throw Error(ExitCode::scene, "the reference is " + size(picture.width, picture.height) +
                                         ", the scene's film " + size(width, height));
    Reference r = read(picture);
    if (r.rgb.empty()) throw Error(ExitCode::scene, "the reference has no channels R, G, B");
    for (const float value : r.rgb)
        if (!std::isfinite(value))
            throw Error(ExitCode::scene, "the reference has values that are not finite");
    const std::size_t pixels = static_cast<std::size_t>(width) * height;
    if (r.standard_error.empty()) r.standard_error.resize(3 * pixels);
    r.seconds = 0;
    r.has_mask = !r.masked.empty();
    r.masked.resize(pixels);
    if (r.luminance_error.empty())  // light varies in all channels together
        for (std::size_t p = 0; p < pixels; ++p)
            r.luminance_error.push_back(static_cast<float>(luminance(&r.standard_error[3 * p])));
    return r;
}

}  // namespace lobe
