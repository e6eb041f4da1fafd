// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace lobe {

// A linear colour in four bytes, three mantissas and one exponent: within 1/256 of its largest
// channel (G. Ward, "Real Pixels", Graphics Gems II, 1991). A channel is m 2^(e - 136). Negative
// values and NaN become 0, what is too large the largest.
std::array<std::uint8_t, 4> rgbe(const float* rgb);

}  // namespace lobe
