// SPDX-License-Identifier: Apache-2.0
// Does a histogram follow the distribution it should? For any sampler with a density.
#pragma once

#include <vector>

namespace lobe {

struct ChiSquare {
    double statistic, freedom, p;
};

// Pearson's test of counts against expected counts. Cells that expect fewer than five are taken
// together; a sample where none can be gives p = 0. `expected` is scaled to the sum of the counts
// unless `scale` is false (then lost samples count against the sampler, and no degree is taken).
ChiSquare chi_square(const std::vector<double>& counts, std::vector<double> expected,
                     bool scale = true);

}  // namespace lobe
