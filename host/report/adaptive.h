// SPDX-License-Identifier: Apache-2.0
// Samples where the error is: how many more than the mean each tile of a film shall have.
#pragma once

#include <vector>

#include "render/film.h"

namespace lobe {

// Samples a pixel of the pilot whose errors decide, for a render of so many (0: until an error or a
// time is reached). Its samples are thrown away: kept, they would make the picture biased, since a
// tile that looks dark by chance looks quiet too and would be left dark.
std::uint32_t pilot_samples(std::uint32_t samples);

// Another seed, for the pilot of a render.
std::uint64_t pilot_seed(std::uint64_t seed);

// RenderPlan::rates for a picture of least mean squared error (J. Neyman, 1934): a tile's samples
// go with the square root of the variance that one of its pixels has from one sample, without the
// pixels in which a light is seen directly. The pilot's variances are uncertain, so a tile's is
// mixed with its neighbours' and with some of the mean; rates stay between 1/8 and 8, mean 1.
// All 1 if the pilot knows no errors.
std::vector<float> tile_rates(const Film& pilot);

}  // namespace lobe
