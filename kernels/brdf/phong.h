// SPDX-License-Identifier: Apache-2.0
// Phong: f = kd + ks c^n / cos theta_i, c the cosine between wi and the mirror direction.
// Source: B. T. Phong, "Illumination for computer generated pictures", CACM 18(6), 1975, read as a
// BRDF: what it reflects is kd cos theta_i + ks c^n, whatever the light's angle.
//
// n = 0 is a constant where c > 0. normalize: ks is the specular albedo at normal incidence seen
// from the viewer's side and kd the diffuse albedo; n = infinity is then a mirror of reflectance
// ks. Without normalisation the infinite lobe has no energy and vanishes.
//
// Not reciprocal, and no ks > 0 conserves energy: f grows as 1 / cos theta_i, so that a grazing
// beam is reflected many times over (normalised, 7 times for n = 10 at 89 degrees). Sampling:
// diffuse part and lobe by albedo, the lobe by its exact inverse, azimuth over the visible arc;
// cosine sampling would have infinite variance.
#ifndef LOBE_BRDF_PHONG_H
#define LOBE_BRDF_PHONG_H

#include "brdf/cosine_power.h"
#include "core/warp.h"

// clang-format off
#define phong_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse part, 1/sr (normalize: diffuse albedo)") \
    P(color, ks, 0.25, 0, inf, "specular part, 1/sr (normalize: specular albedo at normal incidence)") \
    P(number, n, 100, 0, inf, "specular exponent: 0 rough, infinity a mirror") \
    P(choice, normalize, 0, 0, 1, "false|true: whether kd and ks are albedos")
// clang-format on
LOBE_BRDF_VALUES(phong)

typedef struct {
    real3 kd, ks;  // BRDF values; ks of a mirror is its albedo
    real n;
    real specular, diffuse;  // mean albedos at normal incidence
    real edge;               // how fast the lobe emerges from the horizon;
    int mirror;
} phong_prepared;

phong_prepared phong_prepare(phong_values values) {
    phong_prepared m;
    int infinite = values.n > LOBE_LARGEST_N;
    m.n = smaller(values.n, LOBE_LARGEST_N);
    real albedo = REAL_TWO_PI / (m.n + 1);  // of ks = 1, at normal incidence
    m.kd = values.normalize ? values.kd * REAL_INV_PI : values.kd;
    m.ks = values.normalize ? values.ks / albedo : values.ks;
    m.mirror = infinite && values.normalize;
    if (infinite) m.ks = m.mirror ? values.ks : (real3)(0);
    m.diffuse = REAL_PI * mean_component(m.kd);
    m.specular = mean_component(m.ks) * (m.mirror ? 1 : albedo);
    m.edge = R(0.8) * sqrt(m.n + 1);
    return m;
}

// Nothing: it is not reciprocal, and with any lobe at all gives grazing light back many times over.
int phong_claims(phong_values values) {
    int lambert = is_black(values.ks);
    real3 albedo = values.normalize ? values.kd : REAL_PI * values.kd;
    return LOBE_BRDF_KEEPS_SAMPLES |
           (lambert ? LOBE_BRDF_RECIPROCAL | LOBE_BRDF_CONSERVES_BELOW(albedo) : 0);
}

real3 phong_formula(phong_values values, real3 wo, real3 wi) {
    phong_prepared m = phong_prepare(values);
    real c = dot((real3)(-wo.x, -wo.y, wo.z), wi);
    return c <= 0 ? m.kd : m.kd + m.ks * (pow(c, values.n) / wi.z);
}

// Probabilities of the lobe and of the cosine. The visible part of the lobe, and with it the
// albedo, goes from a half at 90 degrees to all, roughly as a sigmoid of cos theta sqrt(n).
real2 phong_choice(const phong_prepared* m, real3 wo) {
    real z = m->edge * wo.z;
    real visible = R(0.5) + R(0.5) * z / sqrt(fma(z, z, 1));
    return lobe_choice(m->specular * (m->mirror ? 1 : visible), m->diffuse);
}

real3 phong_value(const phong_prepared* m, LobePoint p, real cosine) {
    if (m->mirror) return m->kd * cosine;
    return m->kd * cosine + m->ks * cosine_power(m->n, p);
}

real phong_density(const phong_prepared* m, real2 choice, LobePoint p, real arc, real cosine) {
    real density = choice.y * cosine * REAL_INV_PI;
    if (m->mirror || choice.x == 0) return density;
    return fma(choice.x, cosine_power_density(m->n, p) / arc, density);
}

real3 phong_eval(const phong_prepared* m, real3 wo, real3 wi) {
    return phong_value(m, lobe_point(wo, wi), wi.z);
}

real phong_pdf(const phong_prepared* m, real3 wo, real3 wi) {
    LobePoint p = lobe_point(wo, wi);
    return phong_density(m, phong_choice(m, wo), p, lobe_visible_arc(p, wo), wi.z);
}

BrdfSample phong_sample(const phong_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real2 choice = phong_choice(m, wo);
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
    real pdf = phong_density(m, choice, p, arc, sample.wi.z);
    if (!(sample.wi.z > 0 && pdf > 0)) return brdf_no_sample();
    sample.pdf = pdf;
    sample.weight = phong_value(m, p, sample.wi.z) / pdf;
    return sample;
}

#endif
