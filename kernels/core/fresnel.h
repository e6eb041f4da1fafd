// SPDX-License-Identifier: Apache-2.0
// Fresnel reflectance of unpolarised light at a smooth boundary.
#ifndef LOBE_CORE_FRESNEL_H
#define LOBE_CORE_FRESNEL_H

#include "core/vec.h"

// A dielectric of index eta relative to the side of the light, 0 <= cosine <= 1. Below eta = 1 it
// reflects all light beyond the critical angle.
real fresnel_dielectric(real cosine, real eta) {
    real inside_squared = (eta - 1) * (eta + 1) + cosine * cosine;  // (eta cos of refraction)^2
    if (!(inside_squared > 0)) return 1;
    real inside = sqrt(inside_squared);
    real across = (cosine - inside) / (cosine + inside);
    real along = (eta * eta * cosine - inside) / (eta * eta * cosine + inside);
    return R(0.5) * (across * across + along * along);
}

// One wavelength of a conductor of index eta + i k (S. Lagarde, "Memo on Fresnel equations", 2013,
// whose a^2 cancels for k >> eta: here it is the product of the roots over the other root).
real fresnel_conductor_channel(real cosine, real eta, real k) {
    real c2 = cosine * cosine;
    real s2 = (1 - cosine) * (1 + cosine);
    real t0 = (eta - k) * (eta + k) - 1 + c2;
    real ek = eta * k;
    real sum = sqrt(t0 * t0 + 4 * ek * ek);  // a^2 + b^2
    real a2 = t0 >= 0 ? R(0.5) * (sum + t0) : 2 * ek * ek / (sum - t0);
    real ac = 2 * sqrt(a2) * cosine;
    real across_most = sum + c2 + ac;
    real along_most = c2 * sum + s2 * s2 + ac * s2;
    if (!(across_most > 0 && along_most > 0)) return 1;
    real across = (sum + c2 - ac) / across_most;
    real along = (c2 * sum + s2 * s2 - ac * s2) / along_most;
    return R(0.5) * across * (1 + along);
}

real3 fresnel_conductor(real cosine, real3 eta, real3 k) {
    return (real3)(fresnel_conductor_channel(cosine, eta.x, k.x),
                   fresnel_conductor_channel(cosine, eta.y, k.y),
                   fresnel_conductor_channel(cosine, eta.z, k.z));
}

#endif
