// SPDX-License-Identifier: Apache-2.0
// Kelemen-Szirmay-Kalos: f = kd + ks F D / (4 (o.h)^2), h the half vector, D Beckmann's
// distribution of facets and F = f0 + (1 - f0) (1 - o.h)^5.
// Source: C. Kelemen, L. Szirmay-Kalos, "A microfacet based coupled specular-matte BRDF model with
// importance sampling", Eurographics 2001; of its matte parts the plain one, kd, without the
// article's coupling, which needs the albedo of the facets in a table.
//
// Reciprocal; conserves energy for pi kd + ks <= 1. Sampling: diffuse part by cosine, facets as
// V-shaped grooves show them to the viewer, so that the facets' weight is at most ks; between them
// by albedo. alpha below 0.001 counts as 0.001.
#ifndef LOBE_BRDF_KELEMEN_H
#define LOBE_BRDF_KELEMEN_H

#include "brdf/lobe.h"
#include "core/beckmann.h"
#include "core/warp.h"

// clang-format off
#define kelemen_parameters(P) \
    P(color, kd, 0.2, 0, inf, "diffuse part, 1/sr") \
    P(color, ks, 0.3, 0, inf, "factor of the facets' reflectance") \
    P(color, f0, 0.2, 0, 1, "reflectance of a facet at normal incidence") \
    P(number, alpha, 0.3, 0, 1, "Beckmann roughness, the article's m")
// clang-format on
LOBE_BRDF_VALUES(kelemen)

typedef struct {
    real3 kd, ks, f0;
    real2 alpha;
    real diffuse;  // albedo
} kelemen_prepared;

kelemen_prepared kelemen_prepare(kelemen_values values) {
    kelemen_prepared m;
    m.kd = values.kd;
    m.ks = values.ks;
    m.f0 = values.f0;
    m.alpha = (real2)(larger(values.alpha, BECKMANN_SMOOTHEST));
    m.diffuse = REAL_PI * mean_component(m.kd);
    return m;
}

int kelemen_claims(kelemen_values values) {
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_CONSERVES_BELOW(REAL_PI * values.kd + values.ks) |
           (is_black(values.ks) && !is_black(values.kd) ? LOBE_BRDF_KEEPS_SAMPLES : 0);
}

real3 kelemen_formula(kelemen_values values, real3 wo, real3 wi) {
    real3 h = normalize(wo + wi);
    real m = larger(values.alpha, BECKMANN_SMOOTHEST), lh = dot(wi, h);
    real density = exp(-square(tan(acos(h.z)) / m)) / (REAL_PI * square(m) * pow(h.z, R(4.0)));
    real3 fresnel = values.f0 + (1 - values.f0) * pow(1 - lh, R(5.0));
    return values.kd + values.ks * fresnel * (density / (4 * square(lh)));
}

// Probabilities of facets and cosine. Facets that lie askew are never all seen so steeply that they
// reflect nothing: half the cosine keeps their probability from 0.
real2 kelemen_choice(const kelemen_prepared* m, real3 wo) {
    real3 facets = m->ks * schlick_fresnel(m->f0, 1 - R(0.5) * wo.z);
    return lobe_choice(mean_component(facets), m->diffuse);
}

real3 kelemen_eval(const kelemen_prepared* m, real3 wo, real3 wi) {
    HalfVector h = half_vector(wo, wi);
    return m->kd * wi.z +
           m->ks * schlick_fresnel(m->f0, h.oblique) * beckmann_bounded_eval(h, m->alpha, wi.z);
}

real kelemen_pdf(const kelemen_prepared* m, real3 wo, real3 wi) {
    real2 choice = kelemen_choice(m, wo);
    return fma(choice.x, beckmann_pdf(half_vector(wo, wi), m->alpha, wo.z),
               choice.y * wi.z * REAL_INV_PI);
}

BrdfSample kelemen_sample(const kelemen_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real facets = kelemen_choice(m, wo).x;
    sample.wi = u.z < facets ? beckmann_sample(wo, m->alpha, (real3)(u.xy, u.z / facets))
                             : cosine_hemisphere(u.xy);
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = kelemen_pdf(m, wo, sample.wi);
    if (!(sample.pdf > 0)) return brdf_no_sample();
    sample.weight = kelemen_eval(m, wo, sample.wi) / sample.pdf;
    return sample;
}

#endif
