// SPDX-License-Identifier: Apache-2.0
// Cook-Torrance: f = kd + ks F D G / (4 cos theta_i cos theta_o), D Beckmann's distribution of
// facets and G the shadowing of V-shaped grooves, min(1, 2 h.z o.z / o.h, 2 h.z i.z / o.h).
// Sources: R. L. Cook, K. E. Torrance, "A reflectance model for computer graphics", TOG 1(1), 1982;
// K. E. Torrance, E. M. Sparrow, "Theory for off-specular reflection from roughened surfaces",
// 1967.
//
// F is Fresnel's reflectance of a conductor; k = 0 makes it a dielectric of index eta. denominator
// pi is the article's, in place of 4: beside a D that integrates to one it reflects 4/pi too much.
//
// Reciprocal; conserves energy for pi kd + ks <= 1 (with pi: 4/pi ks), as facets and grooves do.
// Sampling: diffuse part by cosine, facets as the grooves show them to the viewer, so that the
// facets' weight is at most ks (4/pi ks); between them by albedo. alpha below 0.001 counts as
// 0.001.
#ifndef LOBE_BRDF_COOK_TORRANCE_H
#define LOBE_BRDF_COOK_TORRANCE_H

#include "brdf/lobe.h"
#include "core/beckmann.h"
#include "core/fresnel.h"
#include "core/warp.h"

// clang-format off
#define cook_torrance_parameters(P) \
    P(color, kd, 0.2, 0, inf, "diffuse part, 1/sr") \
    P(color, ks, 0.3, 0, inf, "factor of the facets' reflectance") \
    P(color, eta, 1.5, 0, 10000, "real part of the index of refraction") \
    P(color, k, 0, 0, 10000, "imaginary part of the index of refraction") \
    P(number, alpha, 0.3, 0, 1, "Beckmann roughness, the article's m") \
    P(choice, denominator, 0, 0, 1, "four|pi: what divides F D G / (cos cos)")
// clang-format on
LOBE_BRDF_VALUES(cook_torrance)

typedef struct {
    real3 kd, ks;  // ks with 4 over the denominator
    real3 eta, k;
    real2 alpha;
    real specular, diffuse;  // mean ks and albedo
} cook_torrance_prepared;

cook_torrance_prepared cook_torrance_prepare(cook_torrance_values values) {
    cook_torrance_prepared m;
    m.kd = values.kd;
    m.ks = values.denominator ? values.ks * (4 * REAL_INV_PI) : values.ks;
    m.eta = values.eta;
    m.k = values.k;
    m.alpha = (real2)(larger(values.alpha, BECKMANN_SMOOTHEST));
    m.specular = mean_component(m.ks);
    m.diffuse = REAL_PI * mean_component(m.kd);
    return m;
}

int cook_torrance_claims(cook_torrance_values values) {
    cook_torrance_prepared m = cook_torrance_prepare(values);
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_CONSERVES_BELOW(REAL_PI * m.kd + m.ks) |
           (is_black(m.ks) && !is_black(m.kd) ? LOBE_BRDF_KEEPS_SAMPLES : 0);
}

real3 cook_torrance_formula(cook_torrance_values values, real3 wo, real3 wi) {
    real3 h = normalize(wo + wi);
    real m = larger(values.alpha, BECKMANN_SMOOTHEST), oh = dot(wo, h);
    real density = exp(-square(tan(acos(h.z)) / m)) / (REAL_PI * square(m) * pow(h.z, R(4.0)));
    real grooves = fmin(R(1.0), fmin(2 * h.z * wo.z / oh, 2 * h.z * wi.z / oh));
    real3 fresnel = fresnel_conductor(fmin(oh, R(1.0)), values.eta, values.k);
    real denominator = values.denominator ? REAL_PI : 4;
    return values.kd + values.ks * fresnel * (density * grooves / (denominator * wo.z * wi.z));
}

// Probabilities of facets and cosine, as if all facets lay flat.
real2 cook_torrance_choice(const cook_torrance_prepared* m, real3 wo) {
    real fresnel = mean_component(fresnel_conductor(smaller(wo.z, 1), m->eta, m->k));
    return lobe_choice(m->specular * fresnel, m->diffuse);
}

real3 cook_torrance_eval(const cook_torrance_prepared* m, real3 wo, real3 wi) {
    HalfVector h = half_vector(wo, wi);
    real3 fresnel = fresnel_conductor(smaller(R(0.5) * h.length, 1), m->eta, m->k);
    // G / (4 i.z o.z) is h.z over the larger of what half_reflection_density divides by, for either
    // direction: 4 h.z o.z i.z or 2 o.h i.z, and the same exchanged.
    real seen = half_reflection_density(h, wo.z), lit = half_reflection_density(h, wi.z);
    real grooves = smaller(seen, lit * (wi.z / wo.z));
    return m->kd * wi.z + m->ks * fresnel * (beckmann_density(h, m->alpha) * h.cosine * grooves);
}

real cook_torrance_pdf(const cook_torrance_prepared* m, real3 wo, real3 wi) {
    real2 choice = cook_torrance_choice(m, wo);
    return fma(choice.x, beckmann_pdf(half_vector(wo, wi), m->alpha, wo.z),
               choice.y * wi.z * REAL_INV_PI);
}

BrdfSample cook_torrance_sample(const cook_torrance_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real facets = cook_torrance_choice(m, wo).x;
    sample.wi = u.z < facets ? beckmann_sample(wo, m->alpha, (real3)(u.xy, u.z / facets))
                             : cosine_hemisphere(u.xy);
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = cook_torrance_pdf(m, wo, sample.wi);
    if (!(sample.pdf > 0)) return brdf_no_sample();
    sample.weight = cook_torrance_eval(m, wo, sample.wi) / sample.pdf;
    return sample;
}

#endif
