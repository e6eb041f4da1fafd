// SPDX-License-Identifier: Apache-2.0
// Schlick: f = S(o.h) (a / pi + b G(o.z) G(i.z) Z(h.z) A(w) / (4 pi o.z i.z) + c mirror), h the
// half vector, w the cosine of its azimuth, S(u) = C + (1 - C) (1 - u)^5, Z(t) = r / (1 + r t^2 -
// t^2)^2, A(w) = sqrt(p / (p^2 - p^2 w^2 + w^2)) and G(v) = v / (r - r v + v). Source: C. Schlick,
// "An inexpensive BRDF model for physically-based rendering", CGF 13(3), 1994: the single layer, of
// reflectance C, roughness r and isotropy p.
//
// parts mixed: b = 4 r (1 - r), and the rest goes to a mirror (c) for r < 1/2, to a diffuse part
// (a) above: r = 0 is a mirror, r = 1 diffuse. parts glossy: b = 1 alone. shadowed says where the
// share 1 - G G of the light goes that other facets hide: lost, as most use the model; lambertian:
// it leaves again with b (1 - G G) / pi; divided: with b (1 - G G) / (4 pi o.z i.z), as the article
// writes, whose albedo grows as 1 / cos towards grazing views.
//
// Reciprocal. As Z is GGX's distribution for alpha^2 = r, and G at most its shadowing for r >= 1/4,
// energy is conserved there for p = 1 if shadowed light is lost; G is too large for smoother
// facets. Sampling: mirror, diffuse part and facets by albedo, Z by its exact inverse, facets as
// they face the viewer. r counts as 1e-6 and p as 0.001 where they are less.
#ifndef LOBE_BRDF_SCHLICK_H
#define LOBE_BRDF_SCHLICK_H

#include "brdf/lobe.h"
#include "core/half_vector.h"
#include "core/microfacet.h"
#include "core/warp.h"

// clang-format off
#define schlick_parameters(P) \
    P(color, reflectance, 0.5, 0, 1, "reflectance C at normal incidence") \
    P(number, roughness, 0.3, 0, 1, "r: 0 a mirror, 1 diffuse") \
    P(number, isotropy, 1, 0, 1, "p: 1 isotropic; towards 0 facets lean along the second tangent") \
    P(choice, parts, 0, 0, 1, "mixed|glossy: whether a mirror or a diffuse part joins the facets") \
    P(choice, shadowed, 0, 0, 2, "lost|lambertian|divided: where light goes that facets hide")
// clang-format on
LOBE_BRDF_VALUES(schlick)

#define SCHLICK_LAMBERTIAN 1
#define SCHLICK_DIVIDED 2

typedef struct {
    real3 reflectance;
    real r, p, root_p;
    real2 alpha;                   // of the GGX distribution that is Z
    real diffuse, glossy, mirror;  // the article's a, b and c
    real askew;                    // share of the facets' samples that go as a cosine
    int shadowed;
} schlick_prepared;

schlick_prepared schlick_prepare(schlick_values values) {
    schlick_prepared m;
    real r = values.roughness;
    m.reflectance = values.reflectance;
    m.r = larger(r, R(1e-6));
    m.p = larger(values.isotropy, R(1e-3));
    m.root_p = sqrt(m.p);
    m.alpha = (real2)(sqrt(m.r));
    m.glossy = values.parts ? 1 : 4 * r * (1 - r);
    real rest = values.parts ? 0 : square(1 - 2 * r);
    m.diffuse = r < R(0.5) ? 0 : rest;
    m.mirror = r < R(0.5) ? rest : 0;
    m.askew = R(0.1) * square(1 - mean_component(m.reflectance));
    m.shadowed = values.shadowed;
    return m;
}

int schlick_claims(schlick_values values) {
    int no_facets = schlick_prepare(values).glossy == 0;
    int masked = values.roughness >= R(0.25) && values.isotropy == 1 && values.shadowed == 0;
    return LOBE_BRDF_RECIPROCAL | (no_facets ? LOBE_BRDF_KEEPS_SAMPLES : 0) |
           (no_facets || masked ? LOBE_BRDF_CONSERVES_ENERGY : 0);
}

real3 schlick_formula(schlick_values values, real3 wo, real3 wi) {
    schlick_prepared m = schlick_prepare(values);
    real3 h = normalize(wo + wi);
    real t = h.z, u = dot(wi, h), v = wo.z, v2 = wi.z;
    real w = h.x != 0 || h.y != 0 ? h.x / hypot(h.x, h.y) : sqrt(R(0.5));
    real zenith = m.r / square(1 + m.r * t * t - t * t);
    real azimuth = sqrt(m.p / (m.p * m.p - m.p * m.p * w * w + w * w));
    real shadow = v / (m.r - m.r * v + v) * v2 / (m.r - m.r * v2 + v2);
    real d = m.diffuse / REAL_PI + m.glossy * shadow * zenith * azimuth / (4 * REAL_PI * v * v2);
    if (m.shadowed == SCHLICK_LAMBERTIAN) d += m.glossy * (1 - shadow) / REAL_PI;
    if (m.shadowed == SCHLICK_DIVIDED) d += m.glossy * (1 - shadow) / (4 * REAL_PI * v * v2);
    return (values.reflectance + (1 - values.reflectance) * pow(1 - u, R(5.0))) * d;
}

// cos^2 and sin^2 of the half vector's azimuth; halves where it has none.
real2 schlick_azimuth(HalfVector h) {
    real2 side = fabs(h.slope);
    real most = larger(side.x, side.y);
    if (!(most > 0)) return (real2)(R(0.5));
    side /= most;
    side *= side;
    return side / (side.x + side.y);
}

// Probabilities of facets, diffuse part and mirror. All parts share the factor S.
real3 schlick_choice(const schlick_prepared* m, real3 wo) {
    real below = fma(1 - m->r, wo.z, m->r);
    // Facets that reflect little head on: what they do reflect comes from the few that lie far
    // askew, which a cosine finds.
    real diffuse = m->diffuse + m->glossy * m->askew;
    // 1 - G(o.z) G(i.z), the second at its mean cosine of 2/3.
    real hidden = m->glossy * m->r * (2 * (1 - wo.z) + below) / (below * (2 + m->r));
    if (m->shadowed == SCHLICK_DIVIDED) hidden /= 2 * larger(wo.z, R(0.01));
    if (m->shadowed) diffuse += hidden;
    return (real3)(m->glossy, diffuse, m->mirror) / (m->glossy + diffuse + m->mirror);
}

real3 schlick_eval(const schlick_prepared* m, real3 wo, real3 wi) {
    HalfVector h = half_vector(wo, wi);
    real2 azimuth = schlick_azimuth(h);
    real below_o = fma(1 - m->r, wo.z, m->r), below_i = fma(1 - m->r, wi.z, m->r);
    real zenith = ggx_density(wo + wi, m->alpha);  // Z / pi
    real leaning = sqrt(m->p / fma(m->p * m->p, azimuth.y, azimuth.x));
    real d = m->diffuse * wi.z * REAL_INV_PI +
             m->glossy * R(0.25) * zenith * leaning * (wi.z / below_i) / below_o;
    if (m->shadowed) {
        real hidden_o = m->r * (1 - wo.z), hidden_i = m->r * (1 - wi.z);
        real hidden = (hidden_o * wi.z + hidden_i * wo.z + hidden_o * hidden_i) /
                      (below_o * below_i);  // 1 - G G
        d += m->glossy * REAL_INV_PI * hidden *
             (m->shadowed == SCHLICK_DIVIDED ? R(0.25) / larger(wo.z, HALF_VECTOR_TINY) : wi.z);
    }
    return schlick_fresnel(m->reflectance, h.oblique) * d;
}

// What leaves divided by both cosines is spread evenly over the hemisphere, all else as a cosine.
real schlick_diffuse_pdf(const schlick_prepared* m, real wi_z) {
    return m->shadowed == SCHLICK_DIVIDED ? REAL_INV_TWO_PI : wi_z * REAL_INV_PI;
}

// Half vectors have the density Z h.z / pi and an azimuth of density sqrt p / (p sin^2 + cos^2)
// over 2 pi: closed to invert, and at least A.
real schlick_pdf(const schlick_prepared* m, real3 wo, real3 wi) {
    HalfVector h = half_vector(wo, wi);
    real2 azimuth = schlick_azimuth(h);
    real3 choice = schlick_choice(m, wo);
    real facets = ggx_density(wo + wi, m->alpha) * h.cosine * m->root_p /
                  fma(m->p, azimuth.y, azimuth.x) * half_reflection_density(h, wo.z);
    return fma(choice.x, facets, choice.y * schlick_diffuse_pdf(m, wi.z));
}

BrdfSample schlick_sample(const schlick_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real3 choice = schlick_choice(m, wo);
    if (u.z < choice.x) {
        real2 around = (real2)(m->root_p, 1) * real_circle(u.y);
        around *= sqrt(m->r * u.x / ((1 - u.x) * (around.x * around.x + around.y * around.y)));
        sample.wi = half_reflection(wo, (real3)(around, 1), u.z / choice.x);
    } else if (u.z < choice.x + choice.y || choice.z == 0) {
        sample.wi =
            m->shadowed == SCHLICK_DIVIDED ? uniform_cone(u.xy, 1) : cosine_hemisphere(u.xy);
    } else {
        return delta_sample(wo, schlick_fresnel(m->reflectance, larger(1 - wo.z, 0)) * m->mirror,
                            choice.z);
    }
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = schlick_pdf(m, wo, sample.wi);
    if (!(sample.pdf > 0)) return brdf_no_sample();
    sample.weight = schlick_eval(m, wo, sample.wi) / sample.pdf;
    return sample;
}

#endif
