// SPDX-License-Identifier: Apache-2.0
// Stretched rational: f = kd + ks g / max(cos theta_i, cos theta_o), g = c / (n - (n-1) c), c the
// cosine between wi and the mirror direction.
// Sources: C. Schlick, "A fast alternative to Phong's specular model", Graphics Gems IV, 1994 (g);
// L. Neumann, A. Neumann, L. Szirmay-Kalos, "Compact metallic reflectance models", Eurographics
// 1999 (the stretching). That both go together is ours.
//
// The rational lobe that does not darken towards grazing angles. g is 0 for c <= 0. n = 0 is a lobe
// wherever c > 0, n = 1 has g = c, n = infinity is a mirror. normalize: ks is the specular albedo
// at normal incidence and kd the diffuse albedo; n = infinity is then a mirror of reflectance ks.
// Without normalisation the infinite lobe has no energy.
//
// Reciprocal. With the integrals J and K of g and g c over c, the lobe's albedo is 2 pi K ks at
// normal incidence and pi J ks at 90 degrees; in between it may be up to 8.6 % larger than the
// first (at n = 0; 0.03 % at n = 1). Conserves energy where pi kd and a bound of that stay below 1.
// Sampling: diffuse part and lobe by albedo; the lobe by exact inversion, azimuth over the visible
// arc, so that weights are at most 2 pi J ks. For n < 0.05 the lobe is sampled as if n were 0.
#ifndef LOBE_BRDF_STRETCHED_RATIONAL_H
#define LOBE_BRDF_STRETCHED_RATIONAL_H

#include "brdf/rational_lobe.h"
#include "brdf/stretch.h"
#include "core/warp.h"

// clang-format off
#define stretched_rational_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse part, 1/sr (normalize: diffuse albedo)") \
    P(color, ks, 0.25, 0, inf, "specular part, 1/sr (normalize: specular albedo at normal incidence)") \
    P(number, n, 100, 0, inf, "specular parameter: 0 rough, infinity a mirror") \
    P(choice, normalize, 0, 0, 1, "false|true: whether kd and ks are albedos")
// clang-format on
LOBE_BRDF_VALUES(stretched_rational)

typedef struct {
    real3 kd, ks;            // BRDF values; ks of a mirror is its albedo
    real n, a, j;            // a = n - 1, j = integral of the lobe over the cosine
    real density;            // 1 / (area of the lobe): density of a sample at the peak
    real specular, diffuse;  // mean albedos at normal incidence
    real grazing, edge;      // part of the specular one left at 90 degrees; how fast it rises
    int mirror;
} stretched_rational_prepared;

stretched_rational_prepared stretched_rational_prepare(stretched_rational_values values) {
    stretched_rational_prepared m;
    int infinite = values.n > LOBE_LARGEST_N;
    m.n = smaller(values.n, LOBE_LARGEST_N);
    m.a = m.n - 1;
    RationalMoments moments = rational_moments(m.n);
    m.j = moments.j;
    m.density = REAL_INV_TWO_PI / (m.n < RATIONAL_FLAT ? 1 : m.j);
    real albedo = REAL_TWO_PI * moments.k;  // of ks = 1, at normal incidence
    m.kd = values.normalize ? values.kd * REAL_INV_PI : values.kd;
    m.ks = values.normalize ? values.ks / albedo : values.ks;
    m.mirror = infinite && values.normalize;
    if (infinite) m.ks = m.mirror ? values.ks : (real3)(0);
    m.diffuse = REAL_PI * mean_component(m.kd);
    m.specular = mean_component(m.ks) * (m.mirror ? 1 : albedo);
    m.grazing = m.mirror ? 1 : R(0.5) * moments.j / moments.k;
    m.edge = fma(R(0.5), sqrt(sqrt(m.n)), 1);
    return m;
}

// The largest albedo over that at normal incidence, from quadrature, is below 1 + e with
// e = 0.0858 / (1 + 2.8 n)^4.
int stretched_rational_claims(stretched_rational_values values) {
    stretched_rational_prepared m = stretched_rational_prepare(values);
    real excess = R(0.0858) / square(square(fma(R(2.8), smaller(m.n, 1000), 1)));
    real albedo = m.mirror ? 1 : (1 + excess) * REAL_TWO_PI * rational_moments(m.n).k;
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES |
           LOBE_BRDF_CONSERVES_BELOW(REAL_PI * m.kd + albedo * m.ks);
}

real3 stretched_rational_formula(stretched_rational_values values, real3 wo, real3 wi) {
    stretched_rational_prepared m = stretched_rational_prepare(values);
    real c = dot((real3)(-wo.x, -wo.y, wo.z), wi);
    if (c <= 0) return m.kd;
    return m.kd + m.ks * (c / (values.n - (values.n - 1) * c) / fmax(wi.z, wo.z));
}

// Probabilities of the lobe and of the cosine: the lobe's albedo rises from 90 degrees on roughly
// as a sigmoid of cos theta n^(1/4), the inverse of its median angle.
real2 stretched_rational_choice(const stretched_rational_prepared* m, real3 wo) {
    real z = m->edge * wo.z;
    return lobe_choice(m->specular * fma(1 - m->grazing, z / sqrt(fma(z, z, 1)), m->grazing),
                       m->diffuse);
}

real3 stretched_rational_value(const stretched_rational_prepared* m, LobePoint p, real3 wo,
                               real3 wi) {
    if (m->mirror) return m->kd * wi.z;
    return m->kd * wi.z + m->ks * (rational_lobe(m->n, p) * stretched_cosine(wo, wi));
}

real stretched_rational_density(const stretched_rational_prepared* m, real2 choice, LobePoint p,
                                real arc, real cosine) {
    real density = choice.y * cosine * REAL_INV_PI;
    if (m->mirror || choice.x == 0 || !(p.t > 0)) return density;
    real lobe = m->density * (m->n < RATIONAL_FLAT ? 1 : rational_lobe(m->n, p));
    return fma(choice.x, lobe / arc, density);
}

real3 stretched_rational_eval(const stretched_rational_prepared* m, real3 wo, real3 wi) {
    return stretched_rational_value(m, lobe_point(wo, wi), wo, wi);
}

real stretched_rational_pdf(const stretched_rational_prepared* m, real3 wo, real3 wi) {
    LobePoint p = lobe_point(wo, wi);
    return stretched_rational_density(m, stretched_rational_choice(m, wo), p,
                                      lobe_visible_arc(p, wo), wi.z);
}

BrdfSample stretched_rational_sample(const stretched_rational_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real2 choice = stretched_rational_choice(m, wo);
    LobePoint p;
    int from_lobe = u.z < choice.x;
    if (from_lobe) {
        if (m->mirror) return delta_sample(wo, m->ks, choice.x);
        p = rational_invert(m->n, m->a, m->j, u.x);
    } else {
        sample.wi = cosine_hemisphere(u.xy);
        p = lobe_point(wo, sample.wi);
    }
    real arc = lobe_visible_arc(p, wo);
    if (from_lobe) sample.wi = lobe_direction(wo, p, arc * (u.y - R(0.5)));
    real pdf = stretched_rational_density(m, choice, p, arc, sample.wi.z);
    if (!(sample.wi.z > 0 && pdf > 0)) return brdf_no_sample();
    sample.pdf = pdf;
    sample.weight = stretched_rational_value(m, p, wo, sample.wi) / pdf;
    return sample;
}

#endif
