// SPDX-License-Identifier: Apache-2.0
// Modified Phong: f = kd + ks c^n, c the cosine between wi and the mirror direction.
// Sources: R. R. Lewis, "Making shaders more physically plausible", 1994; E. Lafortune, Y. Willems,
// "Using the modified Phong reflectance model for physically based rendering", 1994.
//
// n = 0 is a lobe of constant value where c > 0. normalize: ks is the specular albedo at normal
// incidence (the largest) and kd the diffuse albedo; n = infinity is then a mirror of reflectance
// ks cos theta, the limit of the model. Without normalisation the infinite lobe has no energy.
//
// Reciprocal; conserves energy for pi kd + 2 pi ks / (n + 2) <= 1. Sampling: diffuse part and lobe
// by albedo, the lobe by its exact inverse, azimuth over the visible arc.
#ifndef LOBE_BRDF_MODIFIED_PHONG_H
#define LOBE_BRDF_MODIFIED_PHONG_H

#include "brdf/cosine_power.h"
#include "core/warp.h"

// clang-format off
#define modified_phong_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse part, 1/sr (normalize: diffuse albedo)") \
    P(color, ks, 0.25, 0, inf, "specular part, 1/sr (normalize: specular albedo at normal incidence)") \
    P(number, n, 100, 0, inf, "specular exponent: 0 rough, infinity a mirror") \
    P(choice, normalize, 0, 0, 1, "false|true: whether kd and ks are albedos")
// clang-format on
LOBE_BRDF_VALUES(modified_phong)

typedef struct {
    real3 kd, ks;  // BRDF values; ks of a mirror is its albedo
    real n;
    real specular, diffuse;  // mean albedos at normal incidence
    real grazing;            // part of the specular albedo that is left at 90 degrees;
    int mirror;
} modified_phong_prepared;

modified_phong_prepared modified_phong_prepare(modified_phong_values values) {
    modified_phong_prepared m;
    int infinite = values.n > LOBE_LARGEST_N;
    m.n = smaller(values.n, LOBE_LARGEST_N);
    real albedo = REAL_TWO_PI / (m.n + 2);  // of ks = 1, at normal incidence
    m.kd = values.normalize ? values.kd * REAL_INV_PI : values.kd;
    m.ks = values.normalize ? values.ks / albedo : values.ks;
    m.mirror = infinite && values.normalize;
    if (infinite) m.ks = m.mirror ? values.ks : (real3)(0);
    m.diffuse = REAL_PI * mean_component(m.kd);
    m.specular = mean_component(m.ks) * (m.mirror ? 1 : albedo);
    // Beta((n+1)/2, 3/2) (n + 2) / 2 pi, within 3 % for all n.
    m.grazing = m.mirror ? 0 : R(0.5) / sqrt(fma(R(1.57), m.n, 1));
    return m;
}

int modified_phong_claims(modified_phong_values values) {
    modified_phong_prepared m = modified_phong_prepare(values);
    real albedo = m.mirror ? 1 : REAL_TWO_PI / (m.n + 2);
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES |
           LOBE_BRDF_CONSERVES_BELOW(REAL_PI * m.kd + albedo * m.ks);
}

real3 modified_phong_formula(modified_phong_values values, real3 wo, real3 wi) {
    modified_phong_prepared m = modified_phong_prepare(values);
    real c = dot((real3)(-wo.x, -wo.y, wo.z), wi);
    return c <= 0 ? m.kd : m.kd + m.ks * pow(c, values.n);
}

// Probabilities of the lobe and of the cosine; between its ends the lobe's albedo is near linear.
real2 modified_phong_choice(const modified_phong_prepared* m, real3 wo) {
    return lobe_choice(m->specular * fma(1 - m->grazing, wo.z, m->grazing), m->diffuse);
}

real3 modified_phong_value(const modified_phong_prepared* m, LobePoint p, real cosine) {
    if (m->mirror) return m->kd * cosine;
    return (m->kd + m->ks * cosine_power(m->n, p)) * cosine;
}

real modified_phong_density(const modified_phong_prepared* m, real2 choice, LobePoint p, real arc,
                            real cosine) {
    real density = choice.y * cosine * REAL_INV_PI;
    if (m->mirror || choice.x == 0) return density;
    return fma(choice.x, cosine_power_density(m->n, p) / arc, density);
}

real3 modified_phong_eval(const modified_phong_prepared* m, real3 wo, real3 wi) {
    return modified_phong_value(m, lobe_point(wo, wi), wi.z);
}

real modified_phong_pdf(const modified_phong_prepared* m, real3 wo, real3 wi) {
    LobePoint p = lobe_point(wo, wi);
    return modified_phong_density(m, modified_phong_choice(m, wo), p, lobe_visible_arc(p, wo),
                                  wi.z);
}

BrdfSample modified_phong_sample(const modified_phong_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real2 choice = modified_phong_choice(m, wo);
    LobePoint p;
    int from_lobe = u.z < choice.x;
    if (from_lobe) {
        if (m->mirror) return delta_sample(wo, m->ks * wo.z, choice.x);
        p = cosine_power_point(m->n, u.x);
    } else {
        sample.wi = cosine_hemisphere(u.xy);
        p = lobe_point(wo, sample.wi);
    }
    real arc = lobe_visible_arc(p, wo);
    if (from_lobe) sample.wi = lobe_direction(wo, p, arc * (u.y - R(0.5)));
    real pdf = modified_phong_density(m, choice, p, arc, sample.wi.z);
    if (!(sample.wi.z > 0 && pdf > 0)) return brdf_no_sample();
    sample.pdf = pdf;
    sample.weight = modified_phong_value(m, p, sample.wi.z) / pdf;
    return sample;
}

#endif
