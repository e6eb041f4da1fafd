// SPDX-License-Identifier: Apache-2.0
// The warps and frames for arrays of inputs; u is two numbers an item.
#include "core/frame3.h"
#include "core/warp.h"

#define PROBE_WARP3(function)                                             \
    kernel void warp_##function(global const real* u, global real* out) { \
        uint i = get_global_id(0);                                        \
        vstore3(function(vload2(i, u)), i, out);                          \
    }
#define PROBE_WARP2(function)                                             \
    kernel void warp_##function(global const real* u, global real* out) { \
        uint i = get_global_id(0);                                        \
        vstore2(function(vload2(i, u)), i, out);                          \
    }
PROBE_WARP3(cosine_hemisphere)
PROBE_WARP3(uniform_sphere)
PROBE_WARP2(uniform_disk)
PROBE_WARP2(uniform_triangle)

kernel void warp_uniform_cone(global const real* u, real one_minus_cos, global real* out) {
    uint i = get_global_id(0);
    vstore3(uniform_cone(vload2(i, u), one_minus_cos), i, out);
}

// out: both tangents, then v to local and back
kernel void warp_frame(global const real* n, global const real* v, global real* out) {
    uint i = get_global_id(0);
    Frame3 frame = make_frame3(vload3(i, n));
    real3 inside = to_local(&frame, vload3(i, v));
    vstore3(frame.t, 4 * i, out);
    vstore3(frame.b, 4 * i + 1, out);
    vstore3(inside, 4 * i + 2, out);
    vstore3(to_world(&frame, inside), 4 * i + 3, out);
}
