// SPDX-License-Identifier: Apache-2.0
// The elementary functions, one kernel each; `a` and `b` are arguments.
#include "core/fresnel.h"
#include "core/math.h"
#include "core/mis.h"

#define PROBE_ONE(function)                                               \
    kernel void math_##function(global const real* a, global real* out) { \
        out[get_global_id(0)] = real_##function(a[get_global_id(0)]);     \
    }
PROBE_ONE(exp)
PROBE_ONE(expm1)
PROBE_ONE(log)
PROBE_ONE(log1p)

#define PROBE_TWO(name, function)                                                           \
    kernel void math_##name(global const real* a, global const real* b, global real* out) { \
        out[get_global_id(0)] = function(a[get_global_id(0)], b[get_global_id(0)]);         \
    }
PROBE_TWO(power, real_power)
PROBE_TWO(log_split, real_log_split)
PROBE_TWO(angle, real_angle)
PROBE_TWO(power_heuristic, power_heuristic)
PROBE_TWO(balance_heuristic, balance_heuristic)
PROBE_TWO(fresnel_dielectric, fresnel_dielectric)

kernel void math_circle(global const real* turns, global real* out) {
    vstore2(real_circle(turns[get_global_id(0)]), get_global_id(0), out);
}

kernel void math_circle_octant(global const real* turns, global real* out) {
    vstore2(real_circle_octant(turns[get_global_id(0)]), get_global_id(0), out);
}

kernel void math_fresnel_conductor(global const real* cosine, global const real* eta,
                                   global const real* k, global real* out) {
    uint i = get_global_id(0);
    out[i] = fresnel_conductor(cosine[i], (real3)(eta[i]), (real3)(k[i])).y;
}
