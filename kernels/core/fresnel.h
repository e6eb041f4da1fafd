// SPDX-License-Identifier: Apache-2.0
// Fresnel reflectance of unpolarised light at a smooth boundary.
#ifndef LOBE_CORE_FRESNEL_H
#define LOBE_CORE_FRESNEL_H

#include "core/vec.h"

// A dielectric of index eta relative to the side of the light, 0 <= cosine <= 1. Below eta = 1 it
// reflects all light beyond the critical angle.
real fresnel_dielectric(real cosine, real eta) {
    real step = (eta - 1) * (eta + 1);
    real inside_squared = step + cosine * cosine;  // (eta cos of refraction)^2
    if (!(inside_squared > 0)) return step == 0 ? 0 : 1;
    real inside = sqrt(inside_squared);
    real sine_squared = (1 - cosine) * (1 + cosine);
    real across = step / square(cosine + inside);
    real along = across * (cosine * inside - sine_squared) / (cosine * inside + sine_squared);
    return R(0.5) * (across * across + along * along);
}

// One wavelength of a conductor of index eta + i k. With a + i b = sqrt((eta + i k)^2 - sin^2) the
// reflectances are sums of squares, so that no rounding makes them negative (S. Lagarde, "Memo on
// Fresnel equations", 2013, gives them expanded; its a^2 cancels for k >> eta, b^2 for k << eta:
// here each is half a sum, or the known product a^2 b^2 over the other).
real fresnel_conductor_channel(real cosine, real eta, real k) {
    real c2 = cosine * cosine;
    real s2 = (1 - cosine) * (1 + cosine);
    real t0 = (eta - k) * (eta + k) - 1 + c2;  // a^2 - b^2
    real ab = eta * k;
    real sum = sqrt(t0 * t0 + 4 * ab * ab);  // a^2 + b^2
    real most = R(0.5) * (sum + fabs(t0));
    real least = most > 0 ? ab * ab / most : 0;
    real a = sqrt(t0 >= 0 ? most : least);
    real b2 = t0 >= 0 ? least : most;
    real across_most = square(cosine + a) + b2;
    real along_most = square(a * cosine + s2) + b2 * c2;
    if (!(across_most > 0 && along_most > 0)) return 1;
    real across = (square(cosine - a) + b2) / across_most;
    real along = (square(a * cosine - s2) + b2 * c2) / along_most;
    return R(0.5) * across * (1 + along);
}

real3 fresnel_conductor(real cosine, real3 eta, real3 k) {
    return (real3)(fresnel_conductor_channel(cosine, eta.x, k.x),
                   fresnel_conductor_channel(cosine, eta.y, k.y),
                   fresnel_conductor_channel(cosine, eta.z, k.z));
}

#endif
