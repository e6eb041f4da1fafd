// SPDX-License-Identifier: Apache-2.0
#include "report/html/pictures.h"

#include <algorithm>
#include <cmath>

#include "base/luminance.h"
#include "report/error_map.h"

namespace lobe {
namespace {

const char* const scale_note =
    "logarithmic: black 0.1 % and less, blue, red, yellow, white 100 % and more; green: not finite";

ImageFile blank(const PictureView& view) {
    ImageFile file;
    file.width = file.full_width = view.width;
    file.height = file.full_height = view.height;
    file.channels = {"R", "G", "B"};
    return file;
}

// Blue over white to red for z from -4 to 4.
void add_diverging(std::vector<float>& pixels, double z) {
    static constexpr double cold[3] = {33, 80, 170}, warm[3] = {180, 30, 45};
    static constexpr double odd[3] = {0, 255, 0};
    const double part = std::min(std::abs(z) / 4, 1.0);
    for (int c = 0; c < 3; ++c) {
        const double end = z < 0 ? cold[c] : warm[c];
        const double value = std::isfinite(z) ? 255 + part * (end - 255) : odd[c];
        pixels.push_back(static_cast<float>(std::floor(value + 0.5)));
    }
}

}  // namespace

ReportPicture linear_picture(const std::string& name, const PictureView& view) {
    ImageFile file = blank(view);
    file.pixels = *view.rgb;
    return {name, file, ""};
}

ReportPicture error_picture(const std::string& name, const PictureView& view,
                            const PictureView& reference) {
    return {name, false_colour_error(view, reference),
            std::string("Relative error, ") + scale_note + "."};
}

ReportPicture standard_error_picture(const std::string& name, const PictureView& view) {
    std::vector<float> off = *view.rgb;  // by one standard error
    for (std::size_t i = 0; i < off.size(); ++i) off[i] += (*view.standard_error)[i];
    PictureView moved = view;
    moved.rgb = &off;
    return {name, false_colour_error(moved, view),
            std::string("Standard error over value, ") + scale_note + "."};
}

ReportPicture z_picture(const std::string& name, const PictureView& view,
                        const PictureView& reference) {
    ImageFile file = blank(view);
    file.bytes = true;
    for (std::size_t i = 0; i + 2 < view.rgb->size(); i += 3) {
        double difference[3], error[3];
        for (std::size_t c = 0; c < 3; ++c) {
            difference[c] = double{(*view.rgb)[i + c]} - (*reference.rgb)[i + c];
            error[c] =
                std::hypot((*view.standard_error)[i + c], (*reference.standard_error)[i + c]);
        }
        const double d = luminance(difference);
        add_diverging(file.pixels, d == 0 ? 0 : d / luminance(error));
    }
    return {name, file,
            "Difference over its standard error: blue is darker than the reference, red brighter, "
            "full colour at 4. With few replicates a pixel's standard error is itself rough."};
}

ImageFile cropped(const ImageFile& image, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                  std::uint32_t height) {
    x = std::min(x, image.width);
    y = std::min(y, image.height);
    ImageFile out = image;
    out.width = out.full_width = std::min(width, image.width - x);
    out.height = out.full_height = std::min(height, image.height - y);
    out.pixels.clear();
    const std::size_t channels = image.channels.size();
    for (std::size_t row = y; row < std::size_t(y) + out.height; ++row) {
        const auto from =
            image.pixels.begin() + static_cast<std::ptrdiff_t>((row * image.width + x) * channels);
        out.pixels.insert(out.pixels.end(), from,
                          from + static_cast<std::ptrdiff_t>(out.width * channels));
    }
    return out;
}

}  // namespace lobe
