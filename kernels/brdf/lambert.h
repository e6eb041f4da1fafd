// SPDX-License-Identifier: Apache-2.0
// Lambert: f = kd, the same in every direction; its albedo is pi kd.
// Source: J. H. Lambert, Photometria, 1760.
// Reciprocal; conserves energy for kd <= 1/pi. Sampling: cosine, so the weight is constant.
#ifndef LOBE_BRDF_LAMBERT_H
#define LOBE_BRDF_LAMBERT_H

#include "brdf/brdf.h"
#include "core/warp.h"

// clang-format off
#define lambert_parameters(P) \
    P(color, kd, 0.25, 0, inf, "reflectance divided by pi, 1/sr")
// clang-format on
LOBE_BRDF_VALUES(lambert)

typedef struct {
    real3 kd;
} lambert_prepared;

lambert_prepared lambert_prepare(lambert_values values) {
    lambert_prepared m;
    m.kd = values.kd;
    return m;
}

int lambert_claims(lambert_values values) {
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES |
           LOBE_BRDF_CONSERVES_BELOW(REAL_PI * values.kd);
}

real3 lambert_formula(lambert_values values, real3 wo, real3 wi) { return values.kd; }

real3 lambert_eval(const lambert_prepared* m, real3 wo, real3 wi) { return m->kd * wi.z; }

real lambert_pdf(const lambert_prepared* m, real3 wo, real3 wi) { return wi.z * REAL_INV_PI; }

BrdfSample lambert_sample(const lambert_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    sample.wi = cosine_hemisphere(u.xy);
    sample.pdf = sample.wi.z * REAL_INV_PI;
    sample.weight = m->kd * REAL_PI;
    return sample;
}

#endif
