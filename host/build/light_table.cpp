// SPDX-License-Identifier: Apache-2.0
#include "build/light_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/error.h"

namespace lobe {

// Each light with power gets one grain and, of the grains left, what its part of the running sum
// of powers rounds to: no share can become negative, and all together give exactly the whole.
LightTable make_light_table(const std::vector<PoweredLight>& lights) {
    constexpr std::int64_t grains = 1 << 24;
    double total = 0;
    std::int64_t shining = 0;
    for (const PoweredLight& l : lights) {
        total += l.power;
        shining += l.power > 0;
    }
    LightTable table;
    if (!(total > 0)) return table;
    if (shining > grains)
        throw Error(ExitCode::scene, "the scene has more than 2^24 lights", "",
                    "each triangle of a shining mesh is a light");

    const auto free_grains = static_cast<double>(grains - shining);
    double power = 0;
    std::int64_t with_power = 0, sum = 0;
    for (const PoweredLight& l : lights) {
        power += l.power;
        with_power += l.power > 0;
        const std::int64_t end =
            with_power + std::llround(std::min(1.0, power / total) * free_grains);
        table.lights.push_back(l.light);
        table.lights.back().probability = static_cast<float>(std::ldexp(end - sum, -24));
        table.sums.push_back(static_cast<float>(std::ldexp(end, -24)));
        sum = end;
    }
    return table;
}

}  // namespace lobe
