// SPDX-License-Identifier: Apache-2.0
// Ashikhmin-Shirley: f = 28 rd (1 - rs) / (23 pi) d(theta_i) d(theta_o) + sqrt((nu + 1) (nv + 1)) /
// (8 pi) h.z^(nu cos^2 phi + nv sin^2 phi) F / (o.h max(cos theta_i, cos theta_o)), h the half
// vector, phi its azimuth, d(theta) = 1 - (1 - cos theta / 2)^5 and F = rs + (1 - rs) (1 - o.h)^5.
// Source: M. Ashikhmin, P. Shirley, "An anisotropic Phong BRDF model", JGT 5(2), 2000.
//
// Exponents above 1e8, the sharpest that float directions resolve, count as 1e8. Reciprocal;
// conserves energy: see the claims. Sampling: diffuse part by cosine and lobe by its exact inverse,
// as it faces the viewer; between them by albedo.
#ifndef LOBE_BRDF_ASHIKHMIN_SHIRLEY_H
#define LOBE_BRDF_ASHIKHMIN_SHIRLEY_H

#include "brdf/cosine_power.h"
#include "core/half_vector.h"
#include "core/warp.h"

// clang-format off
#define ashikhmin_shirley_parameters(P) \
    P(color, rd, 0.5, 0, 1, "diffuse reflectance") \
    P(color, rs, 0.05, 0, 1, "specular reflectance at normal incidence") \
    P(number, n_u, 100, 0, inf, "exponent along the first tangent: 0 rough") \
    P(number, n_v, 100, 0, inf, "exponent along the second tangent")
// clang-format on
LOBE_BRDF_VALUES(ashikhmin_shirley)

#define ASHIKHMIN_SHIRLEY_SHARPEST R(1e8)

typedef struct {
    real3 kd, rs;
    real2 n, inverse_root;  // exponents; 1 / sqrt(n + 1)
    real norm;              // sqrt((nu + 1) (nv + 1))
    real rd, beneath;       // means of rd and 1 - rs
} ashikhmin_shirley_prepared;

ashikhmin_shirley_prepared ashikhmin_shirley_prepare(ashikhmin_shirley_values values) {
    ashikhmin_shirley_prepared m;
    real3 beneath = 1 - values.rs;
    m.kd = R(28.0) / 23 * REAL_INV_PI * values.rd * beneath;
    m.rs = values.rs;
    m.n = (real2)(smaller(values.n_u, ASHIKHMIN_SHIRLEY_SHARPEST),
                  smaller(values.n_v, ASHIKHMIN_SHIRLEY_SHARPEST));
    real2 root = sqrt(m.n + 1);
    m.inverse_root = 1 / root;
    m.norm = root.x * root.y;
    m.beneath = mean_component(beneath);
    m.rd = mean_component(values.rd * beneath);
    return m;
}

// The lobe with F = 1 is at most the reflection by V-shaped grooves of facets distributed as
// q / h.z, q the density of half_vector.h: as 2 min(o.z, i.z) h.z <= o.h, it lies below each of its
// bounds. So it conserves energy and, as rs <= 1, it is enough that for rs = 0 it reflects at most
// the (1 - cos theta / 2)^5 that the diffuse part for rd = 1 leaves: quadrature over exponents from
// 0 to 1e8, equal or not, finds that sum nowhere above 0.971.
int ashikhmin_shirley_claims(ashikhmin_shirley_values values) {
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_CONSERVES_ENERGY;
}

real3 ashikhmin_shirley_formula(ashikhmin_shirley_values values, real3 wo, real3 wi) {
    real nu = fmin(values.n_u, ASHIKHMIN_SHIRLEY_SHARPEST);
    real nv = fmin(values.n_v, ASHIKHMIN_SHIRLEY_SHARPEST);
    real3 h = normalize(wo + wi);
    real hk = dot(h, wi), phi = atan2(h.y, h.x);
    real exponent = nu * square(cos(phi)) + nv * square(sin(phi));
    real3 fresnel = values.rs + (1 - values.rs) * pow(1 - hk, R(5.0));
    real lobe =
        sqrt((nu + 1) * (nv + 1)) / (8 * REAL_PI) * pow(h.z, exponent) / (hk * fmax(wo.z, wi.z));
    real depth = expm1(5 * log1p(-wo.z / 2)) * expm1(5 * log1p(-wi.z / 2));
    return fresnel * lobe + 28 / (23 * REAL_PI) * values.rd * (1 - values.rs) * depth;
}

// 1 - (1 - z / 2)^5 without cancellation.
real ashikhmin_shirley_depth(real z) {
    real y = R(0.5) * z;
    return y * fma(y, fma(y, fma(y, y - 5, 10), -10), 5);
}

// h.z to its exponent: near the normal from 1 - h.z.
real ashikhmin_shirley_power(const ashikhmin_shirley_prepared* m, HalfVector h) {
    real x = square(h.slope.x * h.cosine), y = square(h.slope.y * h.cosine);
    real sine_squared = x + y;
    if (!(sine_squared > 0)) return 1;
    LobePoint p;
    p.t = h.cosine;
    p.x = sine_squared / (1 + h.cosine);
    return cosine_power((m->n.x * x + m->n.y * y) / sine_squared, p);
}

// Probabilities of lobe and cosine. What the diffuse part leaves goes to the lobe.
real2 ashikhmin_shirley_choice(const ashikhmin_shirley_prepared* m, real3 wo) {
    real depth = ashikhmin_shirley_depth(wo.z);
    return lobe_choice(1 - m->beneath * depth, m->rd * depth);
}

real3 ashikhmin_shirley_eval(const ashikhmin_shirley_prepared* m, real3 wo, real3 wi) {
    HalfVector h = half_vector(wo, wi);
    real lobe = m->norm * (R(0.5) * REAL_INV_TWO_PI) * ashikhmin_shirley_power(m, h) *
                smaller(wi.z / wo.z, 1) / larger(h.length, HALF_VECTOR_TINY);
    real depth = ashikhmin_shirley_depth(wo.z) * ashikhmin_shirley_depth(wi.z);
    return m->kd * (depth * wi.z) + schlick_fresnel(m->rs, h.oblique) * lobe;
}

real ashikhmin_shirley_pdf(const ashikhmin_shirley_prepared* m, real3 wo, real3 wi) {
    HalfVector h = half_vector(wo, wi);
    real2 choice = ashikhmin_shirley_choice(m, wo);
    real lobe = m->norm * REAL_INV_TWO_PI * ashikhmin_shirley_power(m, h) *
                half_reflection_density(h, wo.z);
    return fma(choice.x, lobe, choice.y * wi.z * REAL_INV_PI);
}

// A half vector of density norm / (2 pi) h.z^exponent. A uniform direction squeezed by 1 / sqrt(n +
// 1) has the lobe's azimuth, and its squared length is one over the exponent plus 1 there.
real3 ashikhmin_shirley_half(const ashikhmin_shirley_prepared* m, real2 u) {
    real2 around = m->inverse_root * real_circle(u.y);
    real squared = around.x * around.x + around.y * around.y;
    real log_t = real_log1p(-u.x) * squared;
    real x = -real_expm1(log_t);
    real t = x < R(0.5) ? 1 - x : real_exp(log_t);
    around *= sqrt(x * (2 - x) / squared);
    return (real3)(around.x, around.y, t);
}

BrdfSample ashikhmin_shirley_sample(const ashikhmin_shirley_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real lobe = ashikhmin_shirley_choice(m, wo).x;
    sample.wi = u.z < lobe ? half_reflection(wo, ashikhmin_shirley_half(m, u.xy), u.z / lobe)
                           : cosine_hemisphere(u.xy);
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = ashikhmin_shirley_pdf(m, wo, sample.wi);
    if (!(sample.pdf > 0)) return brdf_no_sample();
    sample.weight = ashikhmin_shirley_eval(m, wo, sample.wi) / sample.pdf;
    return sample;
}

#endif
