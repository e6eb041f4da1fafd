// SPDX-License-Identifier: Apache-2.0
#include "report/error_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lobe {
namespace {

using Colour = std::array<double, 3>;

constexpr std::array<Colour, 6> ladder = {
    {{0, 0, 0}, {20, 30, 120}, {140, 20, 110}, {225, 60, 30}, {250, 190, 40}, {255, 255, 255}}};
constexpr Colour not_finite = {0, 255, 0};

// From 0 to 1.
Colour colour_at(double place) {
    const double at = std::clamp(place, 0.0, 1.0) * (ladder.size() - 1);
    const std::size_t low = std::min(static_cast<std::size_t>(at), ladder.size() - 2);
    Colour c;
    for (std::size_t k = 0; k < 3; ++k)
        c[k] = ladder[low][k] +
               (at - static_cast<double>(low)) * (ladder[low + 1][k] - ladder[low][k]);
    return c;
}

ImageFile blank(const PictureView& view, std::vector<std::string> channels) {
    ImageFile file;
    file.width = file.full_width = view.width;
    file.height = file.full_height = view.height;
    file.channels = std::move(channels);
    file.pixels.reserve(file.channels.size() * view.width * view.height);
    return file;
}

// Square of the length of three values.
double square(const float* v) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += double(v[c]) * v[c];
    return sum;
}

}  // namespace

ImageFile absolute_error_picture(const PictureView& picture, const PictureView& reference) {
    const auto given = [](const std::vector<float>* v) { return v && !v->empty(); };
    const bool errors = given(picture.standard_error) && given(reference.standard_error);
    ImageFile file = blank(picture, {"R", "G", "B"});
    if (errors) file.channels.insert(file.channels.end(), {"Z.R", "Z.G", "Z.B"});
    for (std::size_t i = 0; i < picture.rgb->size(); i += 3) {
        std::array<double, 3> d;
        for (std::size_t c = 0; c < 3; ++c) {
            d[c] = double((*picture.rgb)[i + c]) - (*reference.rgb)[i + c];
            file.pixels.push_back(static_cast<float>(std::fabs(d[c])));
        }
        for (std::size_t c = 0; errors && c < 3; ++c) {
            const double s =
                std::hypot((*picture.standard_error)[i + c], (*reference.standard_error)[i + c]);
            file.pixels.push_back(d[c] == 0 ? 0 : static_cast<float>(d[c] / s));
        }
    }
    return file;
}

ImageFile false_colour_error(const PictureView& picture, const PictureView& reference) {
    ImageFile file = blank(picture, {"R", "G", "B"});
    file.bytes = true;
    const std::size_t values = picture.rgb->size();
    double squares = 0, finite = 0;
    for (std::size_t i = 0; i < values; i += 3) {
        const double s = square(&(*reference.rgb)[i]);
        if (!std::isfinite(s)) continue;
        squares += s;
        finite += 1;
    }
    const double epsilon = finite > 0 ? 1e-2 * squares / finite : 0;
    for (std::size_t i = 0; i < values; i += 3) {
        double d2 = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = double((*picture.rgb)[i + c]) - (*reference.rgb)[i + c];
            d2 += d * d;
        }
        const double size = square(&(*reference.rgb)[i]) + epsilon;
        const double relative = d2 == 0 ? 0 : std::sqrt(d2 / size);
        const bool known = std::isfinite(d2) && std::isfinite(size);
        const Colour c = !known          ? not_finite
                         : relative == 0 ? ladder[0]
                                         : colour_at(1 + std::log10(relative) / 3);
        for (const double v : c) file.pixels.push_back(static_cast<float>(std::floor(v + 0.5)));
    }
    return file;
}

}  // namespace lobe
