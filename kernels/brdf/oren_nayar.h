// SPDX-License-Identifier: Apache-2.0
// Oren-Nayar: f = kd (A + B max(0, cos(phi_i - phi_o)) sin alpha tan beta), alpha and beta the
// larger and the smaller of theta_i and theta_o.
// Source: M. Oren, S. K. Nayar, "Generalization of Lambert's reflectance model", SIGGRAPH 1994: the
// qualitative model, A = 1 - s^2 / (2 s^2 + 0.66), B = 0.45 s^2 / (s^2 + 0.09), s = sigma in
// radians.
//
// Diffuse V-shaped grooves whose slopes spread by sigma: flatter than Lambert, and brightest where
// the light comes from. sigma = 0 is Lambert; kd is the reflectance of the walls divided by pi.
//
// Reciprocal. The albedo grows from pi kd A at normal incidence to pi kd (A + B / 2) at 90
// degrees and conserves energy where that is at most 1; for sigma = 11 degrees it is 1.015 pi kd.
//
// Sampling: the part of A by the cosine to the normal, that of B by the cosine to the viewer's
// heading along the surface, of which it is at most sin theta_o times. So all weights are bounded,
// where cosine sampling alone has a variance without bound towards 90 degrees.
#ifndef LOBE_BRDF_OREN_NAYAR_H
#define LOBE_BRDF_OREN_NAYAR_H

#include "brdf/brdf.h"
#include "brdf/heading.h"
#include "brdf/stretch.h"
#include "core/warp.h"

// clang-format off
#define oren_nayar_parameters(P) \
    P(color, kd, 0.25, 0, inf, "reflectance divided by pi, 1/sr") \
    P(number, sigma, 20, 0, 90, "standard deviation of the slopes, degrees")
// clang-format on
LOBE_BRDF_VALUES(oren_nayar)

typedef struct {
    real3 kd;
    real a, b;
} oren_nayar_prepared;

oren_nayar_prepared oren_nayar_prepare(oren_nayar_values values) {
    oren_nayar_prepared m;
    real s2 = square(values.sigma * (REAL_PI / 180));
    m.kd = values.kd;
    m.a = 1 - R(0.5) * s2 / (s2 + R(0.33));
    m.b = R(0.45) * s2 / (s2 + R(0.09));
    return m;
}

int oren_nayar_claims(oren_nayar_values values) {
    oren_nayar_prepared m = oren_nayar_prepare(values);
    real3 albedo = REAL_PI * fma(R(0.5), m.b, m.a) * m.kd;
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES | LOBE_BRDF_CONSERVES_BELOW(albedo);
}

real3 oren_nayar_formula(oren_nayar_values values, real3 wo, real3 wi) {
    real sigma = radians(values.sigma);
    real theta_i = acos(wi.z), theta_o = acos(wo.z);
    real towards = fmax((real)0, cos(atan2(wi.y, wi.x) - atan2(wo.y, wo.x)));
    real a = 1 - R(0.5) * sigma * sigma / (sigma * sigma + R(0.33));
    real b = R(0.45) * sigma * sigma / (sigma * sigma + R(0.09));
    return values.kd *
           (a + b * towards * sin(fmax(theta_i, theta_o)) * tan(fmin(theta_i, theta_o)));
}

typedef struct {
    real2 heading;  // towards the viewer, along the surface
    real back;      // probability of the part of B
} OrenNayarView;

// The parts' albedos are pi kd A and kd B times a closed form.
OrenNayarView oren_nayar_view(const oren_nayar_prepared* m, real3 wo) {
    OrenNayarView view;
    real sine = sqrt(wo.x * wo.x + wo.y * wo.y);
    view.heading = heading_of(wo);
    real theta = REAL_TWO_PI * real_angle(sine, wo.z);
    real outer = wo.z * (1 + sine + sine * sine) / (1 + sine);  // (1 - sin^3) / cos
    real back = m->b * REAL_INV_PI * sine * (theta - sine * wo.z + R(2.0) / 3 * outer);
    view.back = back / (m->a + back);
    return view;
}

// kd apart, f cos theta_i; sin alpha tan beta is both sines over the larger cosine.
real oren_nayar_value(const oren_nayar_prepared* m, real3 wo, real3 wi) {
    real sines = larger(fma(wo.x, wi.x, wo.y * wi.y), 0);  // times cos(phi_i - phi_o)
    return fma(m->b * sines, stretched_cosine(wo, wi), m->a * wi.z);
}

real oren_nayar_density(OrenNayarView view, real3 wi) {
    real back = 2 * larger(fma(view.heading.x, wi.x, view.heading.y * wi.y), 0);
    return REAL_INV_PI * fma(view.back, back, (1 - view.back) * wi.z);
}

real3 oren_nayar_eval(const oren_nayar_prepared* m, real3 wo, real3 wi) {
    return m->kd * oren_nayar_value(m, wo, wi);
}

real oren_nayar_pdf(const oren_nayar_prepared* m, real3 wo, real3 wi) {
    return oren_nayar_density(oren_nayar_view(m, wo), wi);
}

BrdfSample oren_nayar_sample(const oren_nayar_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    OrenNayarView view = oren_nayar_view(m, wo);
    real3 v = cosine_hemisphere(u.xy);
    // About the tangent, the half below the horizon is folded up.
    if (u.z < view.back)
        v = (real3)(v.z * view.heading.x - v.y * view.heading.y,
                    v.z * view.heading.y + v.y * view.heading.x, fabs(v.x));
    if (!(v.z > 0)) return brdf_no_sample();
    sample.wi = v;
    sample.pdf = oren_nayar_density(view, v);
    sample.weight = m->kd * (oren_nayar_value(m, wo, v) / sample.pdf);
    return sample;
}

#endif
