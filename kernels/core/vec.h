// SPDX-License-Identifier: Apache-2.0
// Small vector helpers that OpenCL C lacks.
#ifndef LOBE_CORE_VEC_H
#define LOBE_CORE_VEC_H

#include "core/real.h"

real square(real x) { return x * x; }

// The larger or smaller of two numbers; if either is NaN, b. (fmax would hide a NaN in b.)
real larger(real a, real b) { return a > b ? a : b; }
real smaller(real a, real b) { return a < b ? a : b; }

real largest_component(real3 v) { return larger(v.x, larger(v.y, v.z)); }

int is_black(real3 v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// v in the shading frame mirrored about the normal (0, 0, 1).
real3 reflect_local(real3 v) { return (real3)(-v.x, -v.y, v.z); }

#endif
