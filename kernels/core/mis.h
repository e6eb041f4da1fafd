// SPDX-License-Identifier: Apache-2.0
// Weights that combine two sampling strategies.
#ifndef LOBE_CORE_MIS_H
#define LOBE_CORE_MIS_H

#include "core/real.h"

// p^2 / (p^2 + other^2) for one sample of each strategy (E. Veach, thesis, 1997, 9.2.4). As a
// ratio, since the square of a sharp lobe's density overflows. 0 / 0 gives 0.
real power_heuristic(real p, real other) {
    if (!(p > 0)) return 0;
    real ratio = other / p;
    return 1 / fma(ratio, ratio, 1);
}

// p / (p + other): the same for the balance heuristic (9.2.2), as a ratio too.
real balance_heuristic(real p, real other) { return p > 0 ? 1 / (1 + other / p) : 0; }

#endif
