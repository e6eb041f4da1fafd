// SPDX-License-Identifier: Apache-2.0
// A metal surface: GGX microfacets with the Fresnel reflectance of a conductor.
// Sources: B. Walter et al., "Microfacet models for refraction through rough surfaces", 2007;
// E. Heitz, "Sampling the GGX distribution of visible normals", 2018; parameters as in pbrt.
//
// Below alpha = 0.001 in both directions it is a smooth mirror. Light that bounces between facets
// is lost: 12 % at alpha = 0.3 and normal incidence, 69 % (ln 2) at alpha = 1. Reciprocal;
// conserves energy. Sampling: visible normals, so the weight is at most 1.
#ifndef LOBE_BRDF_CONDUCTOR_H
#define LOBE_BRDF_CONDUCTOR_H

#include "brdf/lobe.h"
#include "core/fresnel.h"
#include "core/microfacet.h"

// clang-format off
#define conductor_parameters(P) \
    P(color, eta, 0.2, 0, 10000, "real part of the index of refraction") \
    P(color, k, 3.9, 0, 10000, "imaginary part of the index of refraction") \
    P(number, alpha_x, 0.1, 0, 10, "GGX roughness along the first tangent; both below 0.001: smooth") \
    P(number, alpha_y, 0.1, 0, 10, "GGX roughness along the second tangent")
// clang-format on
LOBE_BRDF_VALUES(conductor)

typedef struct {
    real3 eta, k;
    real2 alpha;
    int smooth;
} conductor_prepared;

conductor_prepared conductor_prepare(conductor_values values) {
    conductor_prepared m;
    m.eta = values.eta;
    m.k = values.k;
    m.smooth = larger(values.alpha_x, values.alpha_y) < R(1e-3);
    m.alpha = (real2)(larger(values.alpha_x, R(1e-4)), larger(values.alpha_y, R(1e-4)));
    return m;
}

int conductor_claims(conductor_values values) {
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_CONSERVES_ENERGY |
           (conductor_prepare(values).smooth ? LOBE_BRDF_KEEPS_SAMPLES : 0);
}

real3 conductor_formula(conductor_values values, real3 wo, real3 wi) {
    conductor_prepared m = conductor_prepare(values);
    if (m.smooth) return (real3)(0);
    return fresnel_conductor(dot(wi, normalize(wo + wi)), m.eta, m.k) *
           ggx_formula(wo, wi, m.alpha);
}

// Fresnel's factor at the half vector, whose cosine to either unit direction is half their sum.
real3 conductor_fresnel(const conductor_prepared* m, real3 wo, real3 wi) {
    return fresnel_conductor(smaller(R(0.5) * length(wo + wi), 1), m->eta, m->k);
}

real3 conductor_eval(const conductor_prepared* m, real3 wo, real3 wi) {
    if (m->smooth) return (real3)(0);
    return conductor_fresnel(m, wo, wi) * ggx_eval(wo, wi, m->alpha);
}

real conductor_pdf(const conductor_prepared* m, real3 wo, real3 wi) {
    return m->smooth ? 0 : ggx_pdf(wo, wi, m->alpha);
}

BrdfSample conductor_sample(const conductor_prepared* m, real3 wo, real3 u) {
    if (m->smooth) return delta_sample(wo, fresnel_conductor(wo.z, m->eta, m->k), 1);
    BrdfSample sample = brdf_no_sample();
    sample.wi = ggx_sample(wo, m->alpha, u.xy);
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = ggx_pdf(wo, sample.wi, m->alpha);
    sample.weight = conductor_fresnel(m, wo, sample.wi) * ggx_weight(wo, sample.wi, m->alpha);
    return sample;
}

#endif
