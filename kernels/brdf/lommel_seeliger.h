// SPDX-License-Identifier: Apache-2.0
// Lommel-Seeliger: f = w / (4 pi (cos theta_i + cos theta_o)).
// Sources: E. Lommel, "Ueber Fluorescenz", Annalen der Physik 160, 1877; H. Seeliger, "Zur
// Photometrie zerstreut reflectirender Substanzen", Muenchner Sitzungsberichte 18, 1888: light
// scattered once, alike in all directions, below a dark porous surface, as of the Moon.
//
// w is the part of the light that a grain scatters. The albedo is w / 2 (1 - mu ln(1 + 1 / mu)),
// mu = cos theta_o: from 0.153 w at normal incidence to w / 2 at 90 degrees.
//
// Reciprocal, conserves energy. Sampling: exact, so that the weight is the albedo.
#ifndef LOBE_BRDF_LOMMEL_SEELIGER_H
#define LOBE_BRDF_LOMMEL_SEELIGER_H

#include "brdf/rational_lobe.h"

// clang-format off
#define lommel_seeliger_parameters(P) \
    P(color, w, 0.5, 0, 1, "albedo of single scattering")
// clang-format on
LOBE_BRDF_VALUES(lommel_seeliger)

typedef struct {
    real3 w;
} lommel_seeliger_prepared;

lommel_seeliger_prepared lommel_seeliger_prepare(lommel_seeliger_values values) {
    lommel_seeliger_prepared m;
    m.w = values.w;
    return m;
}

int lommel_seeliger_claims(lommel_seeliger_values values) {
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES |
           LOBE_BRDF_CONSERVES_BELOW(R(0.5) * values.w);
}

real3 lommel_seeliger_formula(lommel_seeliger_values values, real3 wo, real3 wi) {
    return values.w / (4 * REAL_PI * (wi.z + wo.z));
}

// The integral of mu / (mu + mu_o) over mu in [0, 1]: in [0.3, 1].
real lommel_seeliger_integral(real mu_o) { return 1 - mu_o * (real_log1p(mu_o) - real_log(mu_o)); }

// r in r - ln(1 + r) = d, a branch of Lambert's W: as the rational lobe's inverse for n < 1, the
// polynomial rational_q near 0 and Newton's steps for 1 + r beyond.
real lommel_seeliger_ratio(real d) {
    if (d <= R(1.62)) {
        real s = sqrt(2 * d);
        return s * rational_q(-s);
    }
    real y = 1 + d + real_log(1 + d + real_log(1 + d));
    for (int i = 0; i < 2; ++i) y = (d + real_log(y)) * (y / (y - 1));
    return y - 1;
}

real3 lommel_seeliger_eval(const lommel_seeliger_prepared* m, real3 wo, real3 wi) {
    return m->w * (R(0.5) * REAL_INV_TWO_PI * wi.z / (wi.z + wo.z));
}

real lommel_seeliger_pdf(const lommel_seeliger_prepared* m, real3 wo, real3 wi) {
    real share = wi.z / (wi.z + wo.z) / lommel_seeliger_integral(wo.z);
    return REAL_INV_TWO_PI * share;
}

// mu / mu_o = r has the distribution (r - ln(1 + r)) mu_o / integral.
BrdfSample lommel_seeliger_sample(const lommel_seeliger_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    real integral = lommel_seeliger_integral(wo.z);
    real mu = wo.z * lommel_seeliger_ratio((1 - u.x) * integral / wo.z);
    mu = smaller(mu, 1);
    real2 across = sqrt((1 - mu) * (1 + mu)) * real_circle(u.y);
    sample.wi = (real3)(across.x, across.y, mu);
    sample.pdf = lommel_seeliger_pdf(m, wo, sample.wi);
    sample.weight = m->w * (R(0.5) * integral);
    return sample;
}

#endif
