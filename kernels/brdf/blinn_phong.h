// SPDX-License-Identifier: Apache-2.0
// Blinn-Phong: f = kd + ks c^n, c the cosine between the normal and the half vector of wo and wi.
// Sources: J. F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH
// 1977 (the lobe); the albedo at normal incidence is an elementary integral.
//
// n = 0 is Lambert. Its highlight is about that of modified Phong with n / 4, narrower across than
// along at grazing angles. normalize: ks is the specular albedo at normal incidence (the largest)
// and kd the diffuse albedo; n = infinity is then a mirror of reflectance ks cos^2 theta, the limit
// of the model. Without normalisation the infinite lobe has no energy.
//
// Reciprocal; conserves energy for pi kd + 8 pi ks (2^(-n/2) + n) / ((n + 2) (n + 4)) <= 1, as the
// albedo falls from normal incidence to 8 pi ks / ((n + 2) (n + 4)) at 90 degrees. Sampling:
// diffuse part and lobe by albedo; half vectors by cos^(n+1), restricted to what reflects above the
// horizon, azimuth over the visible arc. For n < 4 the cosine has less variance and
// serves both parts.
#ifndef LOBE_BRDF_BLINN_PHONG_H
#define LOBE_BRDF_BLINN_PHONG_H

#include "brdf/arc.h"
#include "brdf/cosine_power.h"
#include "brdf/heading.h"
#include "core/warp.h"

// clang-format off
#define blinn_phong_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse part, 1/sr (normalize: diffuse albedo)") \
    P(color, ks, 0.25, 0, inf, "specular part, 1/sr (normalize: specular albedo at normal incidence)") \
    P(number, n, 100, 0, inf, "specular exponent: 0 rough, infinity a mirror") \
    P(choice, normalize, 0, 0, 1, "false|true: whether kd and ks are albedos")
// clang-format on
LOBE_BRDF_VALUES(blinn_phong)

#define BLINN_PHONG_WIDE R(4.0)  // below, samples are cosine samples
#define BLINN_PHONG_FINE R(1e6)  // above, rounding moves half vectors by parts of the lobe's width

typedef struct {
    real3 kd, ks;  // BRDF values; ks of a mirror is its albedo
    real n;
    real specular, diffuse;  // mean albedos at normal incidence
    real grazing;            // part of the specular albedo that is left at 90 degrees
    int mirror;
} blinn_phong_prepared;

// Albedo of ks = 1 at normal incidence over that at 90 degrees, 2^(-n/2) + n.
real blinn_phong_ratio(real n) { return n + real_exp(R(-0.34657359027997264) * n); }

real blinn_phong_albedo(real n) {
    return 4 * REAL_TWO_PI / (n + 2) * (blinn_phong_ratio(n) / (n + 4));
}

blinn_phong_prepared blinn_phong_prepare(blinn_phong_values values) {
    blinn_phong_prepared m;
    int infinite = values.n > LOBE_LARGEST_N;
    m.n = smaller(values.n, LOBE_LARGEST_N);
    real albedo = blinn_phong_albedo(m.n);
    m.kd = values.normalize ? values.kd * REAL_INV_PI : values.kd;
    m.ks = values.normalize ? values.ks / albedo : values.ks;
    m.mirror = infinite && values.normalize;
    if (infinite) m.ks = m.mirror ? values.ks : (real3)(0);
    m.diffuse = REAL_PI * mean_component(m.kd);
    m.specular = mean_component(m.ks) * (m.mirror ? 1 : albedo);
    m.grazing = m.mirror ? 0 : 1 / blinn_phong_ratio(m.n);
    return m;
}

int blinn_phong_claims(blinn_phong_values values) {
    blinn_phong_prepared m = blinn_phong_prepare(values);
    real albedo = m.mirror ? 1 : blinn_phong_albedo(m.n);
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES |
           LOBE_BRDF_CONSERVES_BELOW(REAL_PI * m.kd + albedo * m.ks);
}

real3 blinn_phong_formula(blinn_phong_values values, real3 wo, real3 wi) {
    blinn_phong_prepared m = blinn_phong_prepare(values);
    return m.kd + m.ks * pow(normalize(wo + wi).z, values.n);
}

// What value and density want to know of a half vector.
typedef struct {
    LobePoint h;   // its cosine to the normal
    real towards;  // and to wo
    real arc;      // share of all azimuths about the normal that reflect above the horizon
} BlinnPhongHalf;

// From the sum of both directions, scaled first: that of opposite grazing ones may underflow.
// A half vector at theta_h reflects above the horizon where cos phi > -cot theta_o cot 2 theta_h,
// phi from wo's azimuth: the visible arc of a circle at 2 theta_h about wo.
BlinnPhongHalf blinn_phong_half(real3 wo, real3 wi) {
    BlinnPhongHalf half_vector;
    real scale = largest_component(fabs(wo + wi));
    real3 sum = (wo + wi) / scale;
    real across = sum.x * sum.x + sum.y * sum.y, all = fma(sum.z, sum.z, across);
    half_vector.h.t = sum.z / sqrt(all);
    half_vector.h.x = across / (all * (1 + half_vector.h.t));
    half_vector.towards = R(0.5) * scale * sqrt(all);
    LobePoint twice;
    twice.x = 2 * across / all;
    twice.t = fma(sum.z, sum.z, -across) / all;
    if (half_vector.towards > R(0.5)) {
        // The same for unit vectors, without cancellation if one lies flat and one upright.
        real3 flat = wi.z < wo.z ? (real3)(wo.xy, wi.z) : (real3)(wi.xy, wo.z);
        real difference = flat.z * sum.z - (flat.x * sum.x + flat.y * sum.y);
        twice.t = 2 * difference / (scale * all);
    }
    real side = 2 * (wo.x * sum.y - wo.y * sum.x) * sum.z / all;
    half_vector.arc = arc_through(wi, twice, wo, side);
    return half_vector;
}

// Probabilities of half vectors and of the cosine; the lobe's albedo goes about as cos^2 theta.
real2 blinn_phong_choice(const blinn_phong_prepared* m, real3 wo) {
    if (m->n < BLINN_PHONG_WIDE) return (real2)(0, m->specular + m->diffuse > 0 ? 1 : 0);
    return lobe_choice(m->specular * fma(1 - m->grazing, wo.z * wo.z, m->grazing), m->diffuse);
}

// Half vectors reach as far as (90 degrees + theta_o) / 2, whose cosine squared is
// (1 - sin theta_o) / 2. The share of cos^(n+1) within.
real blinn_phong_reach(const blinn_phong_prepared* m, real3 wo) {
    real sine = sqrt(wo.x * wo.x + wo.y * wo.y);
    real log_cosine = R(0.5) * real_log(R(0.5) * wo.z * wo.z / (1 + sine));
    return -real_expm1((m->n + 2) * log_cosine);
}

real3 blinn_phong_value(const blinn_phong_prepared* m, BlinnPhongHalf half_vector, real cosine) {
    if (m->mirror) return m->kd * cosine;
    return (m->kd + m->ks * cosine_power(m->n, half_vector.h)) * cosine;
}

// Per solid angle of wi it is that of the half vector over 4 times its cosine to wo: infinite, in a
// point, between opposite grazing directions; there it stays finite.
real blinn_phong_density(const blinn_phong_prepared* m, real2 choice, BlinnPhongHalf half_vector,
                         real3 wo, real cosine) {
    real density = choice.y * cosine * REAL_INV_PI;
    if (m->mirror || choice.x == 0) return density;
    real lobe = cosine_power_density(m->n + 1, half_vector.h) / blinn_phong_reach(m, wo);
    lobe /= 4 * half_vector.arc * larger(half_vector.towards, R(1e-30));
    return smaller(fma(choice.x, lobe, density), LOBE_LARGEST_N);
}

real3 blinn_phong_eval(const blinn_phong_prepared* m, real3 wo, real3 wi) {
    return blinn_phong_value(m, blinn_phong_half(wo, wi), wi.z);
}

real blinn_phong_pdf(const blinn_phong_prepared* m, real3 wo, real3 wi) {
    return blinn_phong_density(m, blinn_phong_choice(m, wo), blinn_phong_half(wo, wi), wo, wi.z);
}

// The reflection of wo at a half vector of cos^(n+1), with azimuth about the normal from wo's.
real3 blinn_phong_reflect(const blinn_phong_prepared* m, real3 wo, real2 u,
                          BlinnPhongHalf* half_vector) {
    LobePoint h = cosine_power_point(m->n + 1, u.x * blinn_phong_reach(m, wo));
    LobePoint twice;
    twice.x = 2 * h.x * (2 - h.x);
    twice.t = twice.x < R(0.5) ? 1 - twice.x : fma(2 * h.t, h.t, -1);
    half_vector->arc = visible_arc(twice, wo);
    real2 azimuth = real_circle(half_vector->arc * (u.y - R(0.5)));
    real sine = sqrt(wo.x * wo.x + wo.y * wo.y), sine_h = sqrt(h.x * (2 - h.x));
    real2 heading = heading_of(wo);
    half_vector->h = h;
    half_vector->towards = fma(sine * sine_h, azimuth.x, wo.z * h.t);
    real out = 2 * half_vector->towards * sine_h;
    real along = fma(out, azimuth.x, -sine), across = out * azimuth.y;
    // 2 towards cos theta_h - cos theta_o, which would cancel at grazing angles
    real height = fma(wo.z, twice.t, 2 * sine * sine_h * h.t * azimuth.x);
    return (real3)(along * heading.x - across * heading.y, along * heading.y + across * heading.x,
                   height);
}

BrdfSample blinn_phong_sample(const blinn_phong_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real2 choice = blinn_phong_choice(m, wo);
    BlinnPhongHalf half_vector;
    if (u.z < choice.x) {
        if (m->mirror) return delta_sample(wo, m->ks * (wo.z * wo.z), choice.x);
        sample.wi = blinn_phong_reflect(m, wo, u.xy, &half_vector);
    } else {
        sample.wi = cosine_hemisphere(u.xy);
    }
    // That of the rounded wi, as others will see it, unless it is too coarse for the lobe.
    if (!(u.z < choice.x && m->n > BLINN_PHONG_FINE)) half_vector = blinn_phong_half(wo, sample.wi);
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    real pdf = blinn_phong_density(m, choice, half_vector, wo, sample.wi.z);
    if (!(pdf > 0)) return brdf_no_sample();
    sample.pdf = pdf;
    sample.weight = blinn_phong_value(m, half_vector, sample.wi.z) / pdf;
    return sample;
}

#endif
