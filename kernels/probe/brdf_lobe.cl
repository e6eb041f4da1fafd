// SPDX-License-Identifier: Apache-2.0
// Single functions of the lobes for arrays of inputs.
#include "brdf/cosine_power.h"
#include "brdf/rational_lobe.h"

// out: J, K
kernel void lobe_moments(global const real* n, global real* out) {
    uint i = get_global_id(0);
    RationalMoments m = rational_moments(n[i]);
    out[2 * i] = m.j;
    out[2 * i + 1] = m.k;
}

// out: x, t
kernel void lobe_invert(global const real* n, global const real* u, global real* out) {
    uint i = get_global_id(0);
    LobePoint p = rational_invert(n[i], n[i] - 1, rational_moments(n[i]).j, u[i]);
    out[2 * i] = p.x;
    out[2 * i + 1] = p.t;
}

// out: x, t
kernel void lobe_power_point(global const real* n, global const real* u, global real* out) {
    uint i = get_global_id(0);
    LobePoint p = cosine_power_point(n[i], u[i]);
    out[2 * i] = p.x;
    out[2 * i + 1] = p.t;
}

// Lobes at a point: out: g, t^n
kernel void lobe_values(global const real* n, global const real* x, global const real* t,
                        global real* out) {
    uint i = get_global_id(0);
    LobePoint p;
    p.x = x[i];
    p.t = t[i];
    out[2 * i] = rational_lobe(n[i], p);
    out[2 * i + 1] = cosine_power(n[i], p);
}

// From vectors, out: x, t, visible arc
kernel void lobe_geometry(global const real* wo, global const real* wi, global real* out) {
    uint i = get_global_id(0);
    LobePoint p = lobe_point(vload3(i, wo), vload3(i, wi));
    out[3 * i] = p.x;
    out[3 * i + 1] = p.t;
    out[3 * i + 2] = lobe_visible_arc(p, vload3(i, wo));
}
