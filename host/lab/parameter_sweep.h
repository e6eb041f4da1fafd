// SPDX-License-Identifier: Apache-2.0
// The parameters at which a model is checked: made from its table, so that a model that is new to
// us is swept like any other.
#pragma once

#include <string>
#include <vector>

#include "lab/brdf_probe.h"

namespace lobe {

struct ParameterSet {
    BrdfRows rows;
    std::string text;  // "n 100, lobe abs": what differs from the defaults, or "defaults"
};

// The defaults; each parameter in turn over its range (log-spaced; 0 to 1e6 where it has no end),
// under each combination of choices; and corners, where all parameters sit at ends of their ranges.
// At most `most` sets, the defaults first.
std::vector<ParameterSet> parameter_sweep(const BrdfTable& model, std::size_t most);

// Ends and beyond: each number in turn at the smallest and largest values its row permits, up to
// the largest float and infinity, down to the smallest.
std::vector<ParameterSet> extreme_parameters(const BrdfTable& model);

// A number as short as it can be said: "0.25", "1e6".
std::string short_number(double value);

}  // namespace lobe
