// SPDX-License-Identifier: Apache-2.0
// Strauss: f = (Qd cos theta_i + Qs) / (pi cos theta_i) with Qd = (1 - m s) (1 - s^3) C and
// Qs = rj c^(3 / (1 - s)) (1 + m (1 - F(theta_i)) (C - 1)), c the cosine between wi and the mirror
// direction, rj = min(1, s^3 + (s^3 + 0.1) F(theta_i) G(theta_i) G(theta_o)), F and G rational
// functions of the angle.
// Source: P. S. Strauss, "A realistic lighting model for computer animators", IEEE CG&A 10(6),
// 1990, with transparency 0; read as a BRDF by dividing by pi, so that s = 0 is a Lambertian of
// albedo C but for a faint sheen.
//
// Smoothness s and metalness m go from 0 to 1. The lobe has no normalisation: its albedo for the
// viewer is about 2 rj / (h + 1), h = 3 / (1 - s) but at most 3e8, and vanishes towards s = 1,
// where the article leaves it to mirrored rays. Not reciprocal, and does not conserve energy: f
// grows as 1 / cos theta_i, so that a grazing beam is reflected many times over. Sampling: diffuse
// part and lobe by albedo, the lobe by its exact inverse, azimuth over the visible arc.
#ifndef LOBE_BRDF_STRAUSS_H
#define LOBE_BRDF_STRAUSS_H

#include "brdf/cosine_power.h"
#include "core/warp.h"

// clang-format off
#define strauss_parameters(P) \
    P(color, color, 0.5, 0, 1, "colour C of the diffuse part, and of a metal's lobe") \
    P(number, smoothness, 0.5, 0, 1, "s: 0 dull, 1 the sharpest lobe, of exponent 3e8") \
    P(number, metalness, 0, 0, 1, "m: 1 a metal")
// clang-format on
LOBE_BRDF_VALUES(strauss)

#define STRAUSS_F R(1.12)  // where F has its pole, in right angles
#define STRAUSS_G R(1.01)  // where G has its pole
#define STRAUSS_J R(0.1)   // how far rj rises beyond s^3 for the dullest surface

typedef struct {
    real3 kd, metal;  // diffuse part; m (1 - C), what a metal's lobe lacks to white
    real n, normal;   // exponent; the reflectance s^3
    real2 choice;     // probabilities of lobe and cosine
} strauss_prepared;

strauss_prepared strauss_prepare(strauss_values values) {
    strauss_prepared m;
    real s = values.smoothness;
    m.normal = s * s * s;
    m.metal = values.metalness * (1 - values.color);
    m.n = 3 / larger(1 - s, R(1e-8));
    real dull = (1 - s) * (1 + s + s * s);  // 1 - s^3
    m.kd = ((1 - values.metalness) * s + (1 - s)) * dull * REAL_INV_PI * values.color;
    real lobe = 2 / (m.n + 1) * smaller(m.normal + STRAUSS_J, 1);
    m.choice = lobe_choice(lobe, REAL_PI * mean_component(m.kd));
    return m;
}

// Every parameter leaves a lobe, and with it f's pole at grazing light; s = 0, without a pole,
// still gives back 1.06 of a beam at 89.99 degrees besides the diffuse part.
int strauss_claims(strauss_values values) { return LOBE_BRDF_KEEPS_SAMPLES; }

real strauss_pole(real distance) { return 1 / square(distance); }

// G of an angle, given what it lacks to a right one.
real strauss_formula_shadow(real3 w) {
    real lacks = atan2(w.z, length(w.xy)) / (REAL_PI / 2), k = STRAUSS_G;
    return (strauss_pole(k - 1) - strauss_pole(k - 1 + lacks)) /
           (strauss_pole(k - 1) - strauss_pole(k));
}

real3 strauss_formula(strauss_values values, real3 wo, real3 wi) {
    real s = values.smoothness, m = values.metalness, h = 3 / fmax(1 - s, R(1e-8));
    real alpha = atan2(length(wi.xy), wi.z) / (REAL_PI / 2), k = STRAUSS_F;
    real f = (strauss_pole(k - alpha) - strauss_pole(k)) / (strauss_pole(k - 1) - strauss_pole(k));
    real g = strauss_formula_shadow(wi) * strauss_formula_shadow(wo);
    real rd = 1 - s * s * s, rn = 1 - rd;
    real rj = fmin(R(1.0), rn + (rn + STRAUSS_J) * f * g);
    real c = fmax(dot((real3)(-wo.x, -wo.y, wo.z), wi), R(0.0));
    real3 qd = wi.z * (1 - m * s) * rd * values.color;
    real3 dye = m * (1 - values.color);  // 1 + m (1 - f) (C - 1), where that does not cancel
    real3 qs = pow(c, h) * rj * (1 - dye + dye * f);
    return (qd + qs) / (REAL_PI * wi.z);
}

// The angle to the normal (x) and to the horizon (y), in right angles: each exact where small.
real2 strauss_angles(real3 w) {
    real sine = sqrt(w.x * w.x + w.y * w.y);
    return 4 * (real2)(real_angle(sine, w.z), real_angle(w.z, sine));
}

// Both rational functions, with their differences of poles factored.
real strauss_fresnel(real2 angles) {
    real k = STRAUSS_F;
    return angles.x * (k + k - angles.x) / square(k - angles.x) * (square(k - 1) / (k + k - 1));
}

real strauss_shadow(real2 angles) {
    real k = STRAUSS_G;
    return angles.y * (k + k - 2 + angles.y) / square(k - 1 + angles.y) * (square(k) / (k + k - 1));
}

real3 strauss_value(const strauss_prepared* m, LobePoint p, real3 wo, real3 wi) {
    real2 light = strauss_angles(wi);
    real fresnel = strauss_fresnel(light);
    real both = fresnel * strauss_shadow(light) * strauss_shadow(strauss_angles(wo));
    real rj = smaller(fma(m->normal + STRAUSS_J, both, m->normal), 1);
    real3 tint = (1 - m->metal) + m->metal * fresnel;
    return m->kd * wi.z + tint * (rj * REAL_INV_PI * cosine_power(m->n, p));
}

real strauss_density(const strauss_prepared* m, LobePoint p, real arc, real wi_z) {
    return fma(m->choice.x, cosine_power_density(m->n, p) / arc, m->choice.y * wi_z * REAL_INV_PI);
}

real3 strauss_eval(const strauss_prepared* m, real3 wo, real3 wi) {
    return strauss_value(m, lobe_point(wo, wi), wo, wi);
}

real strauss_pdf(const strauss_prepared* m, real3 wo, real3 wi) {
    LobePoint p = lobe_point(wo, wi);
    return strauss_density(m, p, lobe_visible_arc(p, wo), wi.z);
}

BrdfSample strauss_sample(const strauss_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    LobePoint p;
    int from_lobe = u.z < m->choice.x;
    if (from_lobe) {
        p = cosine_power_point(m->n, u.x);
    } else {
        sample.wi = cosine_hemisphere(u.xy);
        p = lobe_point(wo, sample.wi);
    }
    real arc = lobe_visible_arc(p, wo);
    if (from_lobe) sample.wi = lobe_direction(wo, p, arc * (u.y - R(0.5)));
    real pdf = strauss_density(m, p, arc, sample.wi.z);
    if (!(sample.wi.z > 0 && pdf > 0)) return brdf_no_sample();
    sample.pdf = pdf;
    sample.weight = strauss_value(m, p, wo, sample.wi) / pdf;
    return sample;
}

#endif
