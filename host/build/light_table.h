// SPDX-License-Identifier: Apache-2.0
// The lights as the kernels choose among them: by their power.
#pragma once

#include <vector>

#include "shared/types.h"

namespace lobe {

// A light with its power in any common unit; the probability is filled in by make_light_table.
struct PoweredLight {
    LobeLight light;
    double power;
};

struct LightTable {
    std::vector<LobeLight> lights;
    std::vector<float> sums;  // running sum of the probabilities, multiples of 2^-24, the last is 1
};

// Probabilities are whole numbers of 2^-24, the grain of the kernels' random numbers, so that what
// a light is chosen with is exactly what its estimate is divided by. A light of any power gets at
// least one; all without power: an empty table.
LightTable make_light_table(const std::vector<PoweredLight>& lights);

}  // namespace lobe
