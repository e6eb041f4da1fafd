// SPDX-License-Identifier: Apache-2.0
// Glossy: f = kd / pi + ks D G / (4 cos theta_i cos theta_o), GGX facets that reflect all light.
// Source: B. Walter et al., "Microfacet models for refraction through rough surfaces", 2007.
//
// The one glossy model that lobe and the renderers it is measured beside can all express: kd and ks
// are albedos, and n, the exponent of a Phong lobe of like width, sets alpha^2 = 2 / (n + 2).
//
// Reciprocal; conserves energy for kd + ks <= 1. Sampling: the diffuse part and the facets by
// albedo, the facets by their visible normals.
#include "brdf/lobe.h"
#include "core/microfacet.h"
#include "core/warp.h"

// clang-format off
#define glossy_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse albedo") \
    P(color, ks, 0.25, 0, inf, "factor of the facets' reflectance") \
    P(number, n, 100, 0, 1e6, "exponent of the Phong lobe of like width")
// clang-format on
LOBE_BRDF_VALUES(glossy)

typedef struct {
    real3 kd, ks;
    real2 alpha;
    real2 choice;  // probabilities of the facets (x) and of the cosine (y)
} glossy_prepared;

glossy_prepared glossy_prepare(glossy_values values) {
    glossy_prepared m;
    m.kd = values.kd * REAL_INV_PI;
    m.ks = values.ks;
    m.alpha = (real2)(sqrt(2 / (values.n + 2)));
    m.choice = lobe_choice(mean_component(values.ks), mean_component(values.kd));
    return m;
}

int glossy_claims(glossy_values values) {
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_CONSERVES_BELOW(values.kd + values.ks);
}

real3 glossy_formula(glossy_values values, real3 wo, real3 wi) {
    real2 alpha = (real2)(sqrt(2 / (values.n + 2)));
    return values.kd * REAL_INV_PI + values.ks * ggx_formula(wo, wi, alpha);
}

real3 glossy_eval(const glossy_prepared* m, real3 wo, real3 wi) {
    return m->kd * wi.z + m->ks * ggx_eval(wo, wi, m->alpha);
}

real glossy_pdf(const glossy_prepared* m, real3 wo, real3 wi) {
    real facets = m->choice.x > 0 ? m->choice.x * ggx_pdf(wo, wi, m->alpha) : 0;
    return fma(m->choice.y, wi.z * REAL_INV_PI, facets);
}

BrdfSample glossy_sample(const glossy_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    int facets = u.z < m->choice.x;
    sample.wi = facets ? ggx_sample(wo, m->alpha, u.xy) : cosine_hemisphere(u.xy);
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = glossy_pdf(m, wo, sample.wi);
    if (!(sample.pdf > 0)) return brdf_no_sample();
    sample.weight = glossy_eval(m, wo, sample.wi) / sample.pdf;
    return sample;
}
