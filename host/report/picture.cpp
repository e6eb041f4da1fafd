// SPDX-License-Identifier: Apache-2.0
#include "report/picture.h"

#include <algorithm>
#include <cmath>

namespace lobe {

ImageFile float_picture(const Estimate& picture, const PictureFacts& facts) {
    ImageFile file;
    file.width = picture.width;
    file.height = picture.height;
    file.x = facts.frame.window_x;
    file.y = facts.frame.window_y;
    file.full_width = facts.frame.film_width;
    file.full_height = facts.frame.film_height;
    file.attributes = facts.attributes;
    file.channels = {"R", "G", "B"};
    const bool errors = !picture.standard_error.empty();
    if (errors)
        file.channels.insert(file.channels.end(), {"StdError.R", "StdError.G", "StdError.B"});
    const bool uneven = picture.samples != picture.mean_samples;
    if (uneven) file.channels.push_back("SampleCount");
    file.pixels.reserve(picture.rgb.size() / 3 * file.channels.size());
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
        file.pixels.insert(file.pixels.end(), &picture.rgb[i], &picture.rgb[i] + 3);
        if (errors)
            file.pixels.insert(file.pixels.end(), &picture.standard_error[i],
                               &picture.standard_error[i] + 3);
        if (uneven) file.pixels.push_back(static_cast<float>(picture.sample_counts[i / 3]));
    }
    return file;
}

double srgb_encode(double linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 1;
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double srgb_decode(double display) {
    if (!(display > 0)) return 0;
    if (display >= 1) return 1;
    return display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4);
}

ImageFile display_picture(const Estimate& picture, double exposure) {
    ImageFile file;
    file.width = file.full_width = picture.width;
    file.height = file.full_height = picture.height;
    file.channels = {"R", "G", "B"};
    file.bytes = true;
    file.pixels.resize(picture.rgb.size());
    std::transform(picture.rgb.begin(), picture.rgb.end(), file.pixels.begin(), [&](float value) {
        return static_cast<float>(std::floor(255 * srgb_encode(exposure * value) + 0.5));
    });
    return file;
}

}  // namespace lobe
