// SPDX-License-Identifier: Apache-2.0
// Minnaert: f = kd (k + 1) / 2 (cos theta_i cos theta_o)^(k - 1).
// Source: M. Minnaert, "The reciprocity principle in lunar photometry", Astrophysical Journal 93,
// 1941.
//
// k darkens the limb of a planet: k = 1 is Lambert, k > 1 falls off towards grazing angles, k near
// 1/2 makes a full moon's disk flat. The albedo is pi kd cos(theta_o)^(k - 1).
//
// Reciprocal; conserves energy for k >= 1 and pi kd <= 1. With k < 1 the albedo grows without bound
// towards grazing angles, whatever kd. Sampling: exact, cos^k.
#ifndef LOBE_BRDF_MINNAERT_H
#define LOBE_BRDF_MINNAERT_H

#include "brdf/cosine_power.h"

// clang-format off
#define minnaert_parameters(P) \
    P(color, kd, 0.25, 0, inf, "albedo at normal incidence divided by pi, 1/sr") \
    P(number, k, 1.5, 0, 10, "limb darkening: 1 is Lambert")
// clang-format on
LOBE_BRDF_VALUES(minnaert)

typedef struct {
    real3 kd;
    real k;
} minnaert_prepared;

minnaert_prepared minnaert_prepare(minnaert_values values) {
    minnaert_prepared m;
    m.kd = values.kd;
    m.k = values.k;
    return m;
}

int minnaert_claims(minnaert_values values) {
    int bounded = values.k >= 1 || is_black(values.kd);
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES |
           (bounded ? LOBE_BRDF_CONSERVES_BELOW(REAL_PI * values.kd) : 0);
}

real3 minnaert_formula(minnaert_values values, real3 wo, real3 wi) {
    return values.kd * ((values.k + 1) / 2 * pow(wi.z * wo.z, values.k - 1));
}

// ln cos theta; near the normal from 1 - cos = sin^2 / (1 + cos), exact where cos is rounded.
real minnaert_log(real3 w) {
    real x = (w.x * w.x + w.y * w.y) / (1 + w.z);
    return x < R(0.5) ? real_log1p(-x) : real_log(w.z);
}

real3 minnaert_eval(const minnaert_prepared* m, real3 wo, real3 wi) {
    real log_i = minnaert_log(wi);
    real exponent = (m->k - 1) * (log_i + minnaert_log(wo));
    // The cosine goes into the exponent where f alone would overflow.
    real value = exponent < 80 ? real_exp(exponent) * wi.z : real_exp(exponent + log_i);
    return m->kd * (R(0.5) * (m->k + 1) * value);
}

real minnaert_pdf(const minnaert_prepared* m, real3 wo, real3 wi) {
    return (m->k + 1) * REAL_INV_TWO_PI * real_exp(m->k * minnaert_log(wi));
}

BrdfSample minnaert_sample(const minnaert_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    LobePoint p = cosine_power_point(m->k, u.x);
    real2 across = sqrt(p.x * (2 - p.x)) * real_circle(u.y);
    sample.wi = (real3)(across.x, across.y, p.t);
    sample.pdf = cosine_power_density(m->k, p);
    sample.weight = m->kd * (REAL_PI * real_exp((m->k - 1) * minnaert_log(wo)));
    return sample;
}

#endif
