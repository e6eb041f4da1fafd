// SPDX-License-Identifier: Apache-2.0
// Rational Phong: f = kd + ks c / (n - (n-1) c), c the cosine between wi and the mirror direction.
// Sources: C. Schlick, "A fast alternative to Phong's specular model", Graphics Gems IV, 1994 (the
// lobe); R. J. Ro, H. Song, "A rendering method using a better BRDF of Phong model", 2019.
//
// n = 0 is a wide lobe of constant value where c > 0, n = 1 is cos, large n are sharp lobes with
// tails that fall as 1 / angle^2, n = infinity is a mirror. c < 0 would give negative light or a
// pole; `lobe` says what is done: clamp it to 0; take |c| (a second lobe opposite the first, and
// exactly Lambert at n = 0); or do as the 2019 listing does: c = |cos 2 theta_o|, whatever wi.
//
// normalize: ks is the specular albedo at normal incidence (the largest) and kd the diffuse albedo.
// At n = infinity the normalised lobe is a mirror of reflectance ks cos theta, the limit of the
// model; without normalisation it has no energy left and vanishes.
//
// Reciprocal, and conserves energy for pi kd + 2 pi K(n) ks <= 1; but with lobe = listing neither
// side of the reflection knows the other, and it is not reciprocal.
// Sampling: diffuse part and lobe by albedo; the lobe by exact inversion, azimuth over the visible
// arc. For n < 0.05 the lobe is sampled as if n were 0.
#ifndef LOBE_BRDF_RATIONAL_H
#define LOBE_BRDF_RATIONAL_H

#include "brdf/rational_lobe.h"
#include "core/warp.h"

// clang-format off
#define rational_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse part, 1/sr (normalize: diffuse albedo)") \
    P(color, ks, 0.25, 0, inf, "specular part, 1/sr (normalize: specular albedo at normal incidence)") \
    P(number, n, 100, 0, inf, "specular parameter: 0 rough, infinity a mirror") \
    P(choice, normalize, 0, 0, 1, "false|true: whether kd and ks are albedos") \
    P(choice, lobe, 0, 0, 2, "clamp|abs|listing: reading of cos phi below the horizon of the lobe")
// clang-format on
LOBE_BRDF_VALUES(rational)

#define RATIONAL_ABS 1
#define RATIONAL_LISTING 2

typedef struct {
    real3 kd, ks;                     // BRDF values; ks of a mirror is its albedo
    real n, a, j;                     // a = n - 1, j = integral of the lobe over the cosine
    real density;                     // 1 / (area of the lobe): density of a sample at the peak
    real specular, grazing, diffuse;  // mean albedos, specular at normal incidence; its part at 90
    int lobe, mirror;
} rational_prepared;

rational_prepared rational_prepare(rational_values values) {
    rational_prepared m;
    int listing = values.lobe == RATIONAL_LISTING;
    int infinite = values.n > LOBE_LARGEST_N;
    m.lobe = values.lobe;
    m.n = smaller(values.n, LOBE_LARGEST_N);
    m.a = m.n - 1;
    RationalMoments moments = rational_moments(m.n);
    m.j = moments.j;
    m.density = REAL_INV_TWO_PI / (m.n < RATIONAL_FLAT ? 1 : m.j);
    real albedo = listing ? REAL_PI : REAL_TWO_PI * moments.k;  // of ks = 1, at normal incidence
    m.kd = values.normalize ? values.kd * REAL_INV_PI : values.kd;
    m.ks = values.normalize ? values.ks / albedo : values.ks;
    m.mirror = infinite && values.normalize && !listing;
    if (infinite) m.ks = m.mirror ? values.ks : (real3)(0);
    m.diffuse = REAL_PI * mean_component(listing ? m.kd + m.ks : m.kd);
    m.specular = listing ? 0 : mean_component(m.ks) * (m.mirror ? 1 : albedo);
    // The albedo at 90 degrees over that at 0, fitted to the closed form within 5 % to n = 1e4.
    m.grazing = m.mirror ? 0 : R(0.5) * real_exp(R(-0.17) * real_log1p(13 * m.n));
    if (m.lobe == RATIONAL_ABS) m.grazing *= 2;
    return m;
}

int rational_claims(rational_values values) {
    rational_prepared m = rational_prepare(values);
    if (m.lobe == RATIONAL_LISTING)
        return LOBE_BRDF_KEEPS_SAMPLES | LOBE_BRDF_CONSERVES_BELOW(REAL_PI * (m.kd + m.ks));
    real albedo = m.mirror ? 1 : REAL_TWO_PI * rational_moments(m.n).k;
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES |
           LOBE_BRDF_CONSERVES_BELOW(REAL_PI * m.kd + albedo * m.ks);
}

// The 2019 paper's arithmetic; the normalisation is ours.
real3 rational_formula(rational_values values, real3 wo, real3 wi) {
    rational_prepared m = rational_prepare(values);
    real c = dot((real3)(-wo.x, -wo.y, wo.z), wi);
    if (m.lobe == RATIONAL_LISTING) c = 2 * wo.z * wo.z - 1;
    if (m.lobe != 0) c = fabs(c);
    if (c <= 0) return m.kd;
    return m.kd + m.ks * (c / (values.n - (values.n - 1) * c));
}

// Probabilities of the lobe and of the cosine; between its ends the lobe's albedo is near linear.
real2 rational_choice(const rational_prepared* m, real3 wo) {
    return lobe_choice(m->specular * fma(1 - m->grazing, wo.z, m->grazing), m->diffuse);
}

LobePoint rational_point(const rational_prepared* m, real3 wo, real3 wi) {
    LobePoint p;
    if (m->lobe == RATIONAL_LISTING) {
        real s2 = 2 * (wo.x * wo.x + wo.y * wo.y), c2 = 2 * wo.z * wo.z;
        p.x = smaller(s2, c2);
        p.t = 1 - p.x;
        return p;
    }
    p = lobe_point(wo, wi);
    return m->lobe == RATIONAL_ABS && p.t < 0 ? lobe_point(wo, -wi) : p;
}

real3 rational_value(const rational_prepared* m, LobePoint p, real cosine) {
    real3 f = m->mirror ? m->kd : m->kd + m->ks * rational_lobe(m->n, p);
    return f * cosine;
}

// The part of the circle at p that samples fill: two opposite lobes share a whole one at every t.
real rational_arc(const rational_prepared* m, LobePoint p, real3 wo) {
    return m->lobe == RATIONAL_ABS ? 1 : lobe_visible_arc(p, wo);
}

real rational_density(const rational_prepared* m, real2 choice, LobePoint p, real arc,
                      real cosine) {
    real density = choice.y * cosine * REAL_INV_PI;
    if (m->mirror || choice.x == 0 || !(p.t > 0)) return density;
    real lobe = m->density * (m->n < RATIONAL_FLAT ? 1 : rational_lobe(m->n, p));
    return fma(choice.x, lobe / arc, density);
}

real3 rational_eval(const rational_prepared* m, real3 wo, real3 wi) {
    return rational_value(m, rational_point(m, wo, wi), wi.z);
}

real rational_pdf(const rational_prepared* m, real3 wo, real3 wi) {
    LobePoint p = rational_point(m, wo, wi);
    return rational_density(m, rational_choice(m, wo), p, rational_arc(m, p, wo), wi.z);
}

BrdfSample rational_sample(const rational_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real2 choice = rational_choice(m, wo);
    LobePoint p;
    int from_lobe = u.z < choice.x;
    if (from_lobe) {
        if (m->mirror) return delta_sample(wo, m->ks * wo.z, choice.x);
        p = rational_invert(m->n, m->a, m->j, u.x);
    } else {
        sample.wi = cosine_hemisphere(u.xy);
        p = rational_point(m, wo, sample.wi);
    }
    real arc = rational_arc(m, p, wo);
    if (from_lobe) {
        real3 wi = lobe_direction(wo, p, arc * (u.y - R(0.5)));
        sample.wi = m->lobe == RATIONAL_ABS && wi.z < 0 ? -wi : wi;  // the opposite lobe's share
    }
    real pdf = rational_density(m, choice, p, arc, sample.wi.z);
    if (!(sample.wi.z > 0 && pdf > 0)) return brdf_no_sample();
    sample.pdf = pdf;
    sample.weight = rational_value(m, p, sample.wi.z) / pdf;
    return sample;
}

#endif
