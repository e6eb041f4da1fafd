// SPDX-License-Identifier: Apache-2.0
// A perfect mirror: all light that arrives from the mirror direction, times kr.
// Reciprocal; conserves energy for kr <= 1. Sampling: the one direction there is.
#ifndef LOBE_BRDF_MIRROR_H
#define LOBE_BRDF_MIRROR_H

#include "brdf/lobe.h"

// clang-format off
#define mirror_parameters(P) \
    P(color, kr, 0.9, 0, inf, "reflectance")
// clang-format on
LOBE_BRDF_VALUES(mirror)

typedef struct {
    real3 kr;
} mirror_prepared;

mirror_prepared mirror_prepare(mirror_values values) {
    mirror_prepared m;
    m.kr = values.kr;
    return m;
}

int mirror_claims(mirror_values values) {
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES | LOBE_BRDF_CONSERVES_BELOW(values.kr);
}

real3 mirror_eval(const mirror_prepared* m, real3 wo, real3 wi) { return (real3)(0); }

real mirror_pdf(const mirror_prepared* m, real3 wo, real3 wi) { return 0; }

BrdfSample mirror_sample(const mirror_prepared* m, real3 wo, real3 u) {
    return is_black(m->kr) ? brdf_no_sample() : delta_sample(wo, m->kr, 1);
}

#endif
