// SPDX-License-Identifier: Apache-2.0
// Reflection by GGX microfacets with the height-correlated Smith shadowing (B. Walter et al. 2007;
// E. Heitz, "Understanding the masking-shadowing function", JCGT 3(2), 2014).
//
// Everything is written with the stretched length s(w) = |(ax x, ay y, z)| = z (1 + 2 Lambda(w)),
// so that no cosine divides: G2 / (4 zo zi) = 1 / (2 (so zi + si zo)) and
// G1 / (4 zo) = 1 / (2 (zo + so)). Cosines down to the smallest number and alpha down to 1e-4 stay
// finite.
#ifndef LOBE_CORE_MICROFACET_H
#define LOBE_CORE_MICROFACET_H

#include "core/math.h"
#include "core/vec.h"

real ggx_stretched(real3 w, real2 alpha) {
    real x = alpha.x * w.x, y = alpha.y * w.y;
    return sqrt(x * x + y * y + w.z * w.z);
}

// Density of microfacet normals at the half vector of unit wo and wi, from their sum: the
// homogeneous form needs no unit half vector and no tangent.
real ggx_density(real3 sum, real2 alpha) {
    real x = sum.x / alpha.x, y = sum.y / alpha.y;
    real below = x * x + y * y + sum.z * sum.z;
    real q = below > 0 ? dot(sum, sum) / below : 1;  // opposite grazing directions underflow
    return q * q * REAL_INV_PI / (alpha.x * alpha.y);
}

// D G2 / (4 zo zi) times zi: reflectance but for Fresnel's factor. wo.z > 0, wi.z > 0.
real ggx_eval(real3 wo, real3 wi, real2 alpha) {
    real below = ggx_stretched(wo, alpha) + ggx_stretched(wi, alpha) * (wo.z / wi.z);
    return ggx_density(wo + wi, alpha) / (2 * below);
}

// The same in the textbook's form, D G2 / (4 zo zi) with G2 = 1 / (1 + Lambda_o + Lambda_i) and
// angles by their tangents: what ggx_eval is checked against. Without zi times.
real ggx_formula(real3 wo, real3 wi, real2 alpha) {
    real3 h = normalize(wo + wi);
    real slope = (square(h.x / alpha.x) + square(h.y / alpha.y)) / (h.z * h.z);
    real density = 1 / (REAL_PI * alpha.x * alpha.y * square(square(h.z)) * square(1 + slope));
    real to = (square(alpha.x * wo.x) + square(alpha.y * wo.y)) / (wo.z * wo.z);
    real ti = (square(alpha.x * wi.x) + square(alpha.y * wi.y)) / (wi.z * wi.z);
    real lambda = R(0.5) * (sqrt(1 + to) - 1) + R(0.5) * (sqrt(1 + ti) - 1);
    return density / ((1 + lambda) * 4 * wo.z * wi.z);
}

// Density of wi from ggx_sample, per solid angle.
real ggx_pdf(real3 wo, real3 wi, real2 alpha) {
    return ggx_density(wo + wi, alpha) / (2 * (wo.z + ggx_stretched(wo, alpha)));
}

// ggx_eval / ggx_pdf = G2 / G1, at most 1.
real ggx_weight(real3 wo, real3 wi, real2 alpha) {
    real so = ggx_stretched(wo, alpha);
    return (wo.z + so) / fma(ggx_stretched(wi, alpha), wo.z / wi.z, so);
}

// wi mirrored about a microfacet normal drawn as seen from wo: a uniform point of a spherical cap
// (J. Dupuy, A. Benyoub, "Sampling visible GGX normals with spherical caps", 2023). wi.z may be
// negative: light lost to other facets.
real3 ggx_sample(real3 wo, real2 alpha, real2 u) {
    real3 v = normalize((real3)(alpha.x * wo.x, alpha.y * wo.y, wo.z));
    // The cap point c has z in (-v.z, 1]; 1 - z and 1 + z are formed without cancellation.
    real height = (1 - u.x) * (1 + v.z);  // z of c + v
    real sine = sqrt(u.x * (1 + v.z) * (height + (1 - v.z)));
    real2 c = sine * real_circle(u.y);
    real3 h = normalize((real3)(alpha.x * (c.x + v.x), alpha.y * (c.y + v.y), height));
    return 2 * dot(wo, h) * h - wo;
}

#endif
