// SPDX-License-Identifier: Apache-2.0
#include "report/html/rgbe.h"

#include <algorithm>
#include <cmath>

namespace lobe {

std::array<std::uint8_t, 4> rgbe(const float* rgb) {
    const double most = std::ldexp(255.0, 119);  // of 255 mantissa steps at exponent 255
    double clamped[3];
    for (int c = 0; c < 3; ++c) clamped[c] = rgb[c] > 0 ? std::min(double{rgb[c]}, most) : 0;
    const double top = std::max({clamped[0], clamped[1], clamped[2]});
    int exponent = 0;
    std::frexp(top, &exponent);
    // A mantissa of 256 after rounding belongs to the next exponent.
    if (top > 0 && std::lround(std::ldexp(top, 8 - exponent)) > 255) ++exponent;
    if (top == 0 || exponent < -127) return {0, 0, 0, 0};
    std::array<std::uint8_t, 4> out{};
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = static_cast<std::uint8_t>(std::lround(std::ldexp(clamped[c], 8 - exponent)));
    out[3] = static_cast<std::uint8_t>(exponent + 128);
    return out;
}

}  // namespace lobe
