// SPDX-License-Identifier: Apache-2.0
// Neumann-Neumann, or stretched Phong: f = kd + ks c^n / max(cos theta_i, cos theta_o), c the
// cosine between wi and the mirror direction.
// Source: L. Neumann, A. Neumann, L. Szirmay-Kalos, "Compact metallic reflectance models",
// Eurographics 1999.
//
// The reciprocal repair of Phong's 1 / cos theta_i, and of modified Phong's darkening: metals keep
// their brightness towards grazing angles. n = 0 is a constant g = c^n where c > 0. normalize: ks
// is the specular albedo at normal incidence and kd the diffuse albedo; n = infinity is then a
// mirror of reflectance ks. Without normalisation the infinite lobe has no energy.
//
// Reciprocal. At normal incidence the lobe's albedo is that of modified Phong, 2 pi ks / (n + 2),
// and at 90 degrees pi ks / (n + 1); for n >= 2 the first is the largest, below there are up to
// 8.6 % more in between (5/2 - sqrt 2 times at 45 degrees and n = 0). Conserves energy where pi kd
// and a bound of that stay below 1. Sampling: diffuse part and lobe by albedo, the lobe by its
// exact inverse, azimuth over the visible arc; weights are at most 2 pi ks / (n + 1).
#ifndef LOBE_BRDF_NEUMANN_NEUMANN_H
#define LOBE_BRDF_NEUMANN_NEUMANN_H

#include "brdf/cosine_power.h"
#include "brdf/stretch.h"
#include "core/warp.h"

// clang-format off
#define neumann_neumann_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse part, 1/sr (normalize: diffuse albedo)") \
    P(color, ks, 0.25, 0, inf, "specular part, 1/sr (normalize: specular albedo at normal incidence)") \
    P(number, n, 100, 0, inf, "specular exponent: 0 rough, infinity a mirror") \
    P(choice, normalize, 0, 0, 1, "false|true: whether kd and ks are albedos")
// clang-format on
LOBE_BRDF_VALUES(neumann_neumann)

typedef struct {
    real3 kd, ks;  // BRDF values; ks of a mirror is its albedo
    real n;
    real specular, diffuse;  // mean albedos at normal incidence
    real grazing, edge;      // part of the specular one left at 90 degrees; how fast it rises
    int mirror;
} neumann_neumann_prepared;

neumann_neumann_prepared neumann_neumann_prepare(neumann_neumann_values values) {
    neumann_neumann_prepared m;
    int infinite = values.n > LOBE_LARGEST_N;
    m.n = smaller(values.n, LOBE_LARGEST_N);
    real albedo = REAL_TWO_PI / (m.n + 2);  // of ks = 1, at normal incidence
    m.kd = values.normalize ? values.kd * REAL_INV_PI : values.kd;
    m.ks = values.normalize ? values.ks / albedo : values.ks;
    m.mirror = infinite && values.normalize;
    if (infinite) m.ks = m.mirror ? values.ks : (real3)(0);
    m.diffuse = REAL_PI * mean_component(m.kd);
    m.specular = mean_component(m.ks) * (m.mirror ? 1 : albedo);
    m.grazing = m.mirror ? 1 : R(0.5) + R(0.5) / (m.n + 1);
    m.edge = R(0.6) * sqrt(m.n + 1);
    return m;
}

// The largest albedo over that at normal incidence, from quadrature, is below 1 + e with
// e = 0.0858 (1 - n / 2)^6.
int neumann_neumann_claims(neumann_neumann_values values) {
    neumann_neumann_prepared m = neumann_neumann_prepare(values);
    real rest = square(larger(1 - R(0.5) * m.n, 0));
    real albedo = m.mirror ? 1 : fma(R(0.0858), rest * rest * rest, 1) * REAL_TWO_PI / (m.n + 2);
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES |
           LOBE_BRDF_CONSERVES_BELOW(REAL_PI * m.kd + albedo * m.ks);
}

real3 neumann_neumann_formula(neumann_neumann_values values, real3 wo, real3 wi) {
    neumann_neumann_prepared m = neumann_neumann_prepare(values);
    real c = dot((real3)(-wo.x, -wo.y, wo.z), wi);
    return c <= 0 ? m.kd : m.kd + m.ks * (pow(c, values.n) / fmax(wi.z, wo.z));
}

// Probabilities of the lobe and of the cosine: the lobe's albedo rises from 90 degrees on roughly
// as a sigmoid of cos theta sqrt(n).
real2 neumann_neumann_choice(const neumann_neumann_prepared* m, real3 wo) {
    real z = m->edge * wo.z;
    return lobe_choice(m->specular * fma(1 - m->grazing, z / sqrt(fma(z, z, 1)), m->grazing),
                       m->diffuse);
}

real3 neumann_neumann_value(const neumann_neumann_prepared* m, LobePoint p, real3 wo, real3 wi) {
    if (m->mirror) return m->kd * wi.z;
    return m->kd * wi.z + m->ks * (cosine_power(m->n, p) * stretched_cosine(wo, wi));
}

real neumann_neumann_density(const neumann_neumann_prepared* m, real2 choice, LobePoint p, real arc,
                             real cosine) {
    real density = choice.y * cosine * REAL_INV_PI;
    if (m->mirror || choice.x == 0) return density;
    return fma(choice.x, cosine_power_density(m->n, p) / arc, density);
}

real3 neumann_neumann_eval(const neumann_neumann_prepared* m, real3 wo, real3 wi) {
    return neumann_neumann_value(m, lobe_point(wo, wi), wo, wi);
}

real neumann_neumann_pdf(const neumann_neumann_prepared* m, real3 wo, real3 wi) {
    LobePoint p = lobe_point(wo, wi);
    return neumann_neumann_density(m, neumann_neumann_choice(m, wo), p, lobe_visible_arc(p, wo),
                                   wi.z);
}

BrdfSample neumann_neumann_sample(const neumann_neumann_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real2 choice = neumann_neumann_choice(m, wo);
    LobePoint p;
    int from_lobe = u.z < choice.x;
    if (from_lobe) {
        if (m->mirror) return delta_sample(wo, m->ks, choice.x);
        p = cosine_power_point(m->n, u.x);
    } else {
        sample.wi = cosine_hemisphere(u.xy);
        p = lobe_point(wo, sample.wi);
    }
    real arc = lobe_visible_arc(p, wo);
    if (from_lobe) sample.wi = lobe_direction(wo, p, arc * (u.y - R(0.5)));
    real pdf = neumann_neumann_density(m, choice, p, arc, sample.wi.z);
    if (!(sample.wi.z > 0 && pdf > 0)) return brdf_no_sample();
    sample.pdf = pdf;
    sample.weight = neumann_neumann_value(m, p, wo, sample.wi) / pdf;
    return sample;
}

#endif
