// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lobe {

// Rec. 709 luminance of a linear colour, given as anything with three channels [0], [1], [2].
template <typename Colour>
double luminance(const Colour& c) {
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

}  // namespace lobe
