// SPDX-License-Identifier: Apache-2.0
// Plastic: Lambert's reflection below GGX microfacets of a dielectric,
// f = kd + ks F D G / (4 cos theta_i cos theta_o).
// Source: the plastic material of pbrt-v3 (M. Pharr, W. Jakob, G. Humphreys, "Physically Based
// Rendering", 3rd edition, 2016), to which it is equal for eta = 1/1.5 and kd = Kd / pi: pbrt-v3
// passes the two indices in the opposite order, so that its plastic reflects as seen from inside,
// totally beyond 41.8 degrees between light and facet.
//
// Reciprocal; conserves energy for pi kd + ks <= 1. Sampling: diffuse part and facets by albedo,
// facets by their visible normals. alpha below 0.001 counts as 0.001, as in pbrt-v3.
#ifndef LOBE_BRDF_PLASTIC_H
#define LOBE_BRDF_PLASTIC_H

#include "brdf/lobe.h"
#include "core/fresnel.h"
#include "core/microfacet.h"
#include "core/warp.h"

// clang-format off
#define plastic_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse part, 1/sr") \
    P(color, ks, 0.25, 0, inf, "factor of the facets' reflectance") \
    P(number, alpha, 0.1, 0, 10, "GGX roughness") \
    P(number, eta, 1.5, 0.1, 10, "index of refraction below over above the surface")
// clang-format on
LOBE_BRDF_VALUES(plastic)

typedef struct {
    real3 kd, ks;
    real specular, diffuse;  // mean ks and albedo
    real alpha, eta;
} plastic_prepared;

plastic_prepared plastic_prepare(plastic_values values) {
    plastic_prepared m;
    m.kd = values.kd;
    m.ks = values.ks;
    m.alpha = larger(values.alpha, R(1e-3));
    m.eta = values.eta;
    m.specular = mean_component(m.ks);
    m.diffuse = REAL_PI * mean_component(m.kd);
    return m;
}

int plastic_claims(plastic_values values) {
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_CONSERVES_BELOW(REAL_PI * values.kd + values.ks);
}

real3 plastic_formula(plastic_values values, real3 wo, real3 wi) {
    real facets = ggx_formula(wo, wi, (real2)(larger(values.alpha, R(1e-3))));
    return values.kd +
           values.ks * (facets * fresnel_dielectric(dot(wi, normalize(wo + wi)), values.eta));
}

// Probabilities of facets and cosine, as if all facets lay flat.
real2 plastic_choice(const plastic_prepared* m, real3 wo) {
    return lobe_choice(m->specular * fresnel_dielectric(wo.z, m->eta), m->diffuse);
}

real3 plastic_eval(const plastic_prepared* m, real3 wo, real3 wi) {
    // The half vector's cosine to either unit direction is half their sum.
    real fresnel = fresnel_dielectric(smaller(R(0.5) * length(wo + wi), 1), m->eta);
    return m->kd * wi.z + m->ks * (fresnel * ggx_eval(wo, wi, m->alpha));
}

real plastic_pdf(const plastic_prepared* m, real3 wo, real3 wi) {
    real2 choice = plastic_choice(m, wo);
    real facets = choice.x > 0 ? choice.x * ggx_pdf(wo, wi, m->alpha) : 0;
    return fma(choice.y, wi.z * REAL_INV_PI, facets);
}

BrdfSample plastic_sample(const plastic_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    int facets = u.z < plastic_choice(m, wo).x;
    sample.wi = facets ? ggx_sample(wo, m->alpha, u.xy) : cosine_hemisphere(u.xy);
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = plastic_pdf(m, wo, sample.wi);
    if (!(sample.pdf > 0)) return brdf_no_sample();
    sample.weight = plastic_eval(m, wo, sample.wi) / sample.pdf;
    return sample;
}

#endif
