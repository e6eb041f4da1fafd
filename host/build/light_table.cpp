// SPDX-License-Identifier: Apache-2.0
#include "build/light_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lobe {

LightTable make_light_table(const std::vector<PoweredLight>& lights) {
    constexpr std::int64_t grains = 1 << 24;
    double total = 0;
    for (const PoweredLight& l : lights) total += l.power;
    LightTable table;
    if (!(total > 0)) return table;

    std::vector<std::int64_t> shares;
    std::int64_t given = 0;
    for (const PoweredLight& l : lights) {
        const auto share = std::llround(l.power / total * static_cast<double>(grains));
        shares.push_back(l.power > 0 ? std::max<std::int64_t>(1, share) : 0);
        given += shares.back();
    }
    // What rounding gave too much or too little is taken from the brightest.
    *std::max_element(shares.begin(), shares.end()) += grains - given;

    std::int64_t sum = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        table.lights.push_back(lights[i].light);
        table.lights.back().probability = static_cast<float>(std::ldexp(shares[i], -24));
        sum += shares[i];
        table.sums.push_back(static_cast<float>(std::ldexp(sum, -24)));
    }
    return table;
}

}  // namespace lobe
