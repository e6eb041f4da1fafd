// SPDX-License-Identifier: Apache-2.0
// Disney: f = (1 - metallic) (base / pi mix(fd, fss, subsurface) + sheen) + F D G + 0.25 clearcoat
// Fc Dc Gc, with GGX facets D below a coat Dc of a longer tail.
// Source: B. Burley, "Physically-based shading at Disney", SIGGRAPH 2012 course notes, with the
// shadowing G of that year: GGX's for alpha = (1/2 + roughness/2)^2, separable. G and Gc hold
// 1 / (4 cos theta_i cos theta_o).
//
// All parameters go from 0 to 1. Reciprocal. Diffuse part, sheen and coat are added to the facets
// without making room: only facets alone (a metal without coat, or a black base without sheen and
// coat) conserve energy, and those as long as their alpha is at most that of G. Sampling: cosine,
// visible normals of the facets, and the coat by its exact inverse as it faces the viewer; between
// them by albedo. alpha below 0.001 counts as 0.001.
#ifndef LOBE_BRDF_DISNEY_H
#define LOBE_BRDF_DISNEY_H

#include "brdf/lobe.h"
#include "core/half_vector.h"
#include "core/microfacet.h"
#include "core/warp.h"

// clang-format off
#define disney_parameters(P) \
    P(color, base_color, 0.5, 0, 1, "colour of the surface, linear") \
    P(number, metallic, 0, 0, 1, "0 a dielectric, 1 a metal") \
    P(number, subsurface, 0, 0, 1, "share of the diffuse part with a flatter shape") \
    P(number, specular, 0.5, 0, 1, "facets' reflectance at normal incidence, in 0.08") \
    P(number, specular_tint, 0, 0, 1, "how far base_color tints it") \
    P(number, roughness, 0.5, 0, 1, "of diffuse part and facets, whose alpha is its square") \
    P(number, anisotropic, 0, 0, 1, "stretch of highlights along the first tangent") \
    P(number, sheen, 0, 0, 1, "grazing light of cloth") \
    P(number, sheen_tint, 0.5, 0, 1, "how far base_color tints it") \
    P(number, clearcoat, 0, 0, 1, "strength of the coat") \
    P(number, clearcoat_gloss, 1, 0, 1, "of the coat: 0 satin, 1 gloss")
// clang-format on
LOBE_BRDF_VALUES(disney)

typedef struct {
    real3 diffuse, sheen, facets;  // base / pi, sheen's factor, F at normal incidence
    real2 alpha;
    real roughness, subsurface, shadow_alpha;
    real coat, coat_alpha2, coat_norm;  // 0.25 clearcoat; alpha^2 and norm of Dc
    real log_alpha2;                    // ln of coat_alpha2
} disney_prepared;

real3 disney_mix(real3 a, real3 b, real t) { return a + (b - a) * t; }

disney_prepared disney_prepare(disney_values v) {
    disney_prepared m;
    real luminance = R(0.3) * v.base_color.x + R(0.6) * v.base_color.y + R(0.1) * v.base_color.z;
    real3 tint = luminance > 0 ? v.base_color / luminance : (real3)(1);
    m.diffuse = (1 - v.metallic) * REAL_INV_PI * v.base_color;
    m.sheen = (1 - v.metallic) * v.sheen * disney_mix((real3)(1), tint, v.sheen_tint);
    real3 dielectric = R(0.08) * v.specular * disney_mix((real3)(1), tint, v.specular_tint);
    m.facets = disney_mix(dielectric, v.base_color, v.metallic);
    real aspect = sqrt(1 - R(0.9) * v.anisotropic), alpha = square(v.roughness);
    m.alpha = (real2)(larger(alpha / aspect, R(1e-3)), larger(alpha * aspect, R(1e-3)));
    m.shadow_alpha = square(R(0.5) + R(0.5) * v.roughness);
    m.roughness = v.roughness;
    m.subsurface = v.subsurface;
    m.coat = R(0.25) * v.clearcoat;
    m.coat_alpha2 = square(R(0.1) + (R(0.001) - R(0.1)) * v.clearcoat_gloss);
    m.log_alpha2 = real_log(m.coat_alpha2);
    m.coat_norm = (m.coat_alpha2 - 1) * REAL_INV_PI / m.log_alpha2;
    return m;
}

// Facets alone: a distribution of alpha shadowed as if it were rougher reflects less than GGX's own
// shadowing lets through.
int disney_claims(disney_values values) {
    disney_prepared m = disney_prepare(values);
    int facets_alone = is_black(m.diffuse) && is_black(m.sheen) && m.coat == 0;
    int masked = larger(m.alpha.x, m.alpha.y) <= m.shadow_alpha;
    return LOBE_BRDF_RECIPROCAL | (facets_alone && masked ? LOBE_BRDF_CONSERVES_ENERGY : 0);
}

real disney_lerp(real a, real b, real t) { return a + (b - a) * t; }

real disney_smith(real z, real alpha) {
    return 1 / (z + sqrt(alpha * alpha + z * z - alpha * alpha * z * z));
}

real3 disney_formula(disney_values v, real3 wo, real3 wi) {
    real3 h = normalize(wo + wi);
    real lh = dot(wi, h), luminance = dot(v.base_color, (real3)(R(0.3), R(0.6), R(0.1)));
    real fl = pow(1 - wi.z, R(5.0)), fv = pow(1 - wo.z, R(5.0)), fh = pow(1 - lh, R(5.0));
    real fd90 = R(0.5) + 2 * lh * lh * v.roughness, fss90 = lh * lh * v.roughness;
    real fd = disney_lerp(1, fd90, fl) * disney_lerp(1, fd90, fv);
    real fss = disney_lerp(1, fss90, fl) * disney_lerp(1, fss90, fv);
    real ss = R(1.25) * (fss * (1 / (wi.z + wo.z) - R(0.5)) + R(0.5));
    real3 tint = luminance > 0 ? v.base_color / luminance : (real3)(1);
    real3 sheen = fh * v.sheen * mix((real3)(1), tint, v.sheen_tint);
    real3 dielectric = v.specular * R(0.08) * mix((real3)(1), tint, v.specular_tint);
    real3 fs = mix(mix(dielectric, v.base_color, v.metallic), (real3)(1), fh);
    real aspect = sqrt(1 - v.anisotropic * R(0.9)), rg = square(v.roughness * R(0.5) + R(0.5));
    real ax = fmax(R(0.001), square(v.roughness) / aspect);
    real ay = fmax(R(0.001), square(v.roughness) * aspect);
    real ds = 1 / (REAL_PI * ax * ay * square(square(h.x / ax) + square(h.y / ay) + h.z * h.z));
    real a2 = square(disney_lerp(R(0.1), R(0.001), v.clearcoat_gloss));
    real dr = (a2 - 1) / (REAL_PI * log(a2) * (1 + (a2 - 1) * h.z * h.z));
    real gs = disney_smith(wi.z, rg) * disney_smith(wo.z, rg);
    real gr = disney_smith(wi.z, R(0.25)) * disney_smith(wo.z, R(0.25));
    return (REAL_INV_PI * disney_lerp(fd, ss, v.subsurface) * v.base_color + sheen) *
               (1 - v.metallic) +
           gs * fs * ds + R(0.25) * v.clearcoat * gr * disney_lerp(R(0.04), 1, fh) * dr;
}

// Separable Smith shadowing over 4 cos theta_i cos theta_o, times cos theta_i.
real disney_shadow(real3 wo, real3 wi, real alpha) {
    real2 both = (real2)(alpha);
    return wi.z / ((wo.z + ggx_stretched(wo, both)) * (wi.z + ggx_stretched(wi, both)));
}

// Density of the coat's normals: like GGX's with the exponent 1 in place of 2.
real disney_coat_density(const disney_prepared* m, HalfVector h) {
    real sine_squared = square(h.slope.x * h.cosine) + square(h.slope.y * h.cosine);
    return m->coat_norm / fma(m->coat_alpha2, h.cosine * h.cosine, sine_squared);
}

// 1 to `grazing` as Schlick's weight rises towards z = 0: 1 - (1 - z)^5 is summed up, for it would
// cancel.
real disney_towards(real grazing, real z) {
    real rest = z * fma(z, fma(z, fma(z, fma(z, 1, -5), 10), -10), 5);
    return fma(grazing, 1 - rest, rest);
}

// Diffuse part times cos theta_i, over its factor.
real disney_diffuse(const disney_prepared* m, HalfVector h, real o, real i) {
    real flat90 = square(R(0.5) * h.length) * m->roughness, retro90 = R(0.5) + 2 * flat90;
    real retro = disney_towards(retro90, o) * disney_towards(retro90, i) * i;
    real flat = disney_towards(flat90, o) * disney_towards(flat90, i);
    real through = R(1.25) * (flat * (i / (i + o)) + R(0.5) * i * (1 - flat));
    return (1 - m->subsurface) * retro + m->subsurface * through;
}

// Probabilities of cosine, facets and coat. Half the cosine: facets lie askew.
real3 disney_choice(const disney_prepared* m, real3 wo) {
    real grazing = schlick_weight(1 - R(0.5) * wo.z);
    real3 choice =
        (real3)(REAL_PI * mean_component(m->diffuse) + mean_component(m->sheen) * grazing,
                mean_component(m->facets + (1 - m->facets) * grazing),
                m->coat * fma(R(0.96), grazing, R(0.04)));
    return choice / (choice.x + choice.y + choice.z);
}

real3 disney_eval(const disney_prepared* m, real3 wo, real3 wi) {
    HalfVector h = half_vector(wo, wi);
    real weight = schlick_weight(h.oblique);
    real facets = ggx_density(wo + wi, m->alpha) * disney_shadow(wo, wi, m->shadow_alpha);
    real coat = m->coat * fma(R(0.96), weight, R(0.04)) * disney_coat_density(m, h) *
                disney_shadow(wo, wi, R(0.25));
    return m->diffuse * disney_diffuse(m, h, wo.z, wi.z) + m->sheen * (weight * wi.z) +
           (m->facets + (1 - m->facets) * weight) * facets + coat;
}

real disney_pdf(const disney_prepared* m, real3 wo, real3 wi) {
    HalfVector h = half_vector(wo, wi);
    real3 choice = disney_choice(m, wo);
    real coat = disney_coat_density(m, h) * h.cosine * half_reflection_density(h, wo.z);
    return choice.x * wi.z * REAL_INV_PI + choice.y * ggx_pdf(wo, wi, m->alpha) + choice.z * coat;
}

// A normal of the coat, not of unit length.
real3 disney_coat_normal(const disney_prepared* m, real2 u) {
    real sine = m->coat_alpha2 * real_expm1(-u.x * m->log_alpha2);
    real cosine = -real_expm1((1 - u.x) * m->log_alpha2);
    return (real3)(sqrt(sine / cosine) * real_circle(u.y), 1);
}

BrdfSample disney_sample(const disney_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real3 choice = disney_choice(m, wo);
    real past = u.z - choice.x;
    if (past < 0)
        sample.wi = cosine_hemisphere(u.xy);
    else if (past < choice.y || choice.z == 0)
        sample.wi = ggx_sample(wo, m->alpha, u.xy);
    else
        sample.wi = half_reflection(wo, disney_coat_normal(m, u.xy),
                                    smaller((past - choice.y) / choice.z, 1));
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = disney_pdf(m, wo, sample.wi);
    if (!(sample.pdf > 0)) return brdf_no_sample();
    sample.weight = disney_eval(m, wo, sample.wi) / sample.pdf;
    return sample;
}

#endif
