// SPDX-License-Identifier: Apache-2.0
// The arithmetic that lobe avoids beside lobe's own: formulas as they are printed, for arrays of
// inputs, so that tests can show what float makes of them.
#include "brdf/cosine_power.h"
#include "brdf/rational.h"
#include "core/frame3.h"

// The rational lobe at a given cosine c. out: as printed, with one rounding fewer, lobe's
kernel void naive_rational(global const real* n, global const real* c, global real* out) {
    uint i = get_global_id(0);
    LobePoint p;
    p.t = c[i];
    p.x = 1 - c[i];
    out[3 * i] = c[i] / (n[i] - (n[i] - 1) * c[i]);
    out[3 * i + 1] = c[i] / fma(-(n[i] - 1), c[i], n[i]);
    out[3 * i + 2] = rational_lobe(n[i], p);
}

// Both lobes of unit vectors in the world. out: the rational lobe as printed, with the cosine
// clamped and a stable denominator, from the vectors' difference, through a shading frame as lobe
// does it; c^n as printed, with the cosine clamped, through the frame
kernel void naive_vectors(global const real* n, global const real* normal, global const real* wo,
                          global const real* wi, global real* out) {
    uint i = get_global_id(0);
    real3 up = vload3(i, normal), view = vload3(i, wo), light = vload3(i, wi);
    real3 mirror = 2 * dot(up, view) * up - view;
    real c = dot(mirror, light), clamped = smaller(c, 1);
    LobePoint world;
    world.x = R(0.5) * dot(mirror - light, mirror - light);
    world.t = world.x < R(0.5) ? 1 - world.x : c;
    Frame3 frame = make_frame3(up);
    LobePoint framed = lobe_point(to_local(&frame, view), to_local(&frame, light));
    out[7 * i] = c / (n[i] - (n[i] - 1) * c);
    out[7 * i + 1] = clamped / (clamped + n[i] * (1 - clamped));
    out[7 * i + 2] = rational_lobe(n[i], world);
    out[7 * i + 3] = rational_lobe(n[i], framed);
    out[7 * i + 4] = pow(c, n[i]);
    out[7 * i + 5] = pow(clamped, n[i]);
    out[7 * i + 6] = cosine_power(n[i], framed);
}

// out: ln n / (n - 1), J, K
kernel void naive_moments(global const real* n, global real* out) {
    uint i = get_global_id(0);
    real a = n[i] - 1, l = log(n[i]);
    out[3 * i] = l / a;
    out[3 * i + 1] = (n[i] * l - a) / (a * a);
    out[3 * i + 2] = (2 * n[i] * n[i] * l - 3 * n[i] * n[i] + 4 * n[i] - 1) / (2 * a * a * a);
}

// Points of the density 1 / (n - (n-1) t) and of t^n. out: x = 1 - t and t of the first as printed,
// both from expm1; the sine of the second as printed, and from lobe's point
kernel void naive_points(global const real* n, global const real* u, global real* out) {
    uint i = get_global_id(0);
    real a = n[i] - 1, t = (n[i] - pow(n[i], u[i])) / a, log_n = real_log(n[i]);
    out[6 * i] = 1 - t;
    out[6 * i + 1] = t;
    out[6 * i + 2] = real_expm1(u[i] * log_n) / a;
    out[6 * i + 3] = -n[i] * real_expm1((u[i] - 1) * log_n) / a;
    real power = pow(1 - u[i], 1 / (n[i] + 1));
    LobePoint p = cosine_power_point(n[i], u[i]);
    out[6 * i + 4] = sqrt(1 - power * power);
    out[6 * i + 5] = sqrt(p.x * (2 - p.x));
}

// A sample of the rational model without diffuse part, taken to the world and back. out: the
// density that it carries, the density as printed there, lobe's of the direction that came back
kernel void naive_return(global const real* n, global const real* normal, global const real* wo,
                         global const real* u, global real* out) {
    uint i = get_global_id(0);
    rational_values values;
    values.kd = (real3)(0);
    values.ks = (real3)(1);
    values.n = n[i];
    values.normalize = values.lobe = 0;
    rational_prepared m = rational_prepare(values);
    real3 view = vload3(i, wo);
    BrdfSample sample = rational_sample(&m, view, vload3(i, u));
    Frame3 frame = make_frame3(vload3(i, normal));
    real3 world = to_world(&frame, sample.wi);
    real c = dot(to_world(&frame, reflect_local(view)), world);
    out[3 * i] = sample.pdf;
    real3 back = to_local(&frame, world);
    real arc = lobe_visible_arc(lobe_point(view, back), view);
    out[3 * i + 1] = REAL_INV_TWO_PI / m.j * (c / (n[i] - (n[i] - 1) * c)) / arc;
    out[3 * i + 2] = rational_pdf(&m, view, back);
}

// The frame of J. R. Frisvad, "Building an orthonormal basis from a 3D unit vector without
// normalization", 2012. out: two tangents
kernel void naive_frame(global const real* normal, global real* out) {
    uint i = get_global_id(0);
    real3 n = vload3(i, normal);
    real a = 1 / (1 + n.z), b = -n.x * n.y * a;
    vstore3((real3)(1 - n.x * n.x * a, b, -n.x), 2 * i, out);
    vstore3((real3)(b, 1 - n.y * n.y * a, -n.y), 2 * i + 1, out);
}
