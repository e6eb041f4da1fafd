// SPDX-License-Identifier: Apache-2.0
// Small vector helpers that OpenCL C lacks.
#ifndef LOBE_CORE_VEC_H
#define LOBE_CORE_VEC_H

#include "core/real.h"

real3 make_real3(real x, real y, real z) { return (real3)(x, y, z); }

real square(real x) { return x * x; }

// The larger or smaller of two numbers; if either is NaN, b. (fmax would hide a NaN in b.)
real larger(real a, real b) { return a > b ? a : b; }
real smaller(real a, real b) { return a < b ? a : b; }

real largest_component(real3 v) { return larger(v.x, larger(v.y, v.z)); }

int is_black(real3 v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// Rec. 709 luminance of a linear colour.
real luminance(real3 c) { return R(0.2126) * c.x + R(0.7152) * c.y + R(0.0722) * c.z; }

// v mirrored about the unit vector n: 2 (v.n) n - v. Both point away from the surface.
real3 reflect_about(real3 v, real3 n) { return 2 * dot(v, n) * n - v; }

// v in the shading frame mirrored about the normal (0, 0, 1).
real3 reflect_local(real3 v) { return (real3)(-v.x, -v.y, v.z); }

// a - b c without the cancellation of two roundings (Kahan).
real difference_of_products(real a, real b, real c, real d) {
    real cd = c * d;
    real error = fma(-c, d, cd);
    return fma(a, b, -cd) + error;
}

#endif
