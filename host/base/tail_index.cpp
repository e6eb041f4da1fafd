// SPDX-License-Identifier: Apache-2.0
#include "base/tail_index.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace lobe {

std::optional<TailIndex> tail_index(std::vector<double> values, std::size_t largest) {
    values.erase(std::remove_if(values.begin(), values.end(),
                                [](double v) { return !(v > 0 && std::isfinite(v)); }),
                 values.end());
    if (largest == 0 || values.size() <= largest) return {};
    const auto next = values.begin() + static_cast<std::ptrdiff_t>(largest);
    std::nth_element(values.begin(), next, values.end(), std::greater<>());
    double sum = 0;
    for (auto value = values.begin(); value != next; ++value) sum += std::log(*value / *next);
    if (!(sum > 0)) return {};
    const auto count = static_cast<double>(largest);
    return TailIndex{count / sum, std::sqrt(count) / sum, largest, *next};
}

}  // namespace lobe
