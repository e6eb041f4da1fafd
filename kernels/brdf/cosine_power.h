// SPDX-License-Identifier: Apache-2.0
// The lobe cos^n about the mirror direction, shared by Phong's model and the modified one.
#ifndef LOBE_BRDF_COSINE_POWER_H
#define LOBE_BRDF_COSINE_POWER_H

#include "brdf/lobe.h"

// t^n, 0 for t <= 0 also at n = 0. Near the peak from x: pow(1 + 1 ulp, 1e8) would be 1.5e5.
real cosine_power(real n, LobePoint p) {
    if (!(p.t > 0)) return 0;
    return real_exp(n * real_log_split(p.t, p.x));
}

// Its density per solid angle over the whole lobe is (n + 1) / (2 pi) t^n; u = 0 is the peak.
LobePoint cosine_power_point(real n, real u) {
    LobePoint p;
    real log_t = real_log1p(-u) / (n + 1);
    p.x = -real_expm1(log_t);
    p.t = p.x < R(0.5) ? 1 - p.x : real_exp(log_t);
    return p;
}

real cosine_power_density(real n, LobePoint p) {
    return (n + 1) * REAL_INV_TWO_PI * cosine_power(n, p);
}

#endif
