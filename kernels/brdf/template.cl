// SPDX-License-Identifier: Apache-2.0
// NAME: f = kd + ks ((1 - cos theta_o) (1 - cos theta_i))^n, a diffuse part and a rim as on velvet.
// Source: an example to change, with all that a model needs. The contract it keeps is
// kernels/brdf/README.md of lobe; models that do more are beside that page.
//
// The rim is brightest where viewer and light both graze the surface: wide for n = 1, ever closer
// to the horizon for larger n.
//
// Reciprocal; conserves energy for pi kd + 2 pi ks / ((n + 1) (n + 2)) <= 1. Sampling: diffuse part
// and rim by their largest albedos, each by its exact inverse.
#include "brdf/lobe.h"
#include "core/warp.h"

// What a scene may set: Material "NAME" "rgb kd" [.1 .1 .2] "float n" [8]. One row a parameter:
// P(kind, name, default, lowest, highest, "meaning, unit"); kinds are color, number, integer,
// choice ("first|second: meaning", by number from 0) and table. Every line but the last ends in \.
// clang-format off
#define NAME_parameters(P) \
    P(color, kd, 0.2, 0, inf, "diffuse part, 1/sr") \
    P(color, ks, 0.1, 0, inf, "rim where both directions graze, 1/sr") \
    P(number, n, 4, 1, 1000, "how close the rim keeps to the horizon")
// clang-format on
LOBE_BRDF_VALUES(NAME)

// What eval and sample share, made once a material. At most 512 bytes.
typedef struct {
    real3 kd, ks;
    real n;
    real2 choice;  // probabilities of sampling the rim (x) and the diffuse part (y)
} NAME_prepared;

// The rim's albedo per ks for a grazing viewer, where it is largest: the integral of
// (1 - cos)^n cos over the hemisphere.
real NAME_rim_albedo(real n) { return REAL_TWO_PI / ((n + 1) * (n + 2)); }

// Numbers are written R(0.5), so that the same file also builds in double.
NAME_prepared NAME_prepare(NAME_values values) {
    NAME_prepared m;
    m.kd = values.kd;
    m.ks = values.ks;
    m.n = values.n;
    m.choice =
        lobe_choice(mean_component(m.ks) * NAME_rim_albedo(m.n), mean_component(m.kd) * REAL_PI);
    return m;
}

// What holds for these parameters. lobe brdf check tests it both ways: what is claimed must hold,
// and what is not must be seen to fail somewhere.
int NAME_claims(NAME_values values) {
    real3 albedo = REAL_PI * values.kd + NAME_rim_albedo(values.n) * values.ks;
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES | LOBE_BRDF_CONSERVES_BELOW(albedo);
}

// Optional: f as the source prints it, not times the cosine and whatever its rounding; eval is
// checked against this in double.
real3 NAME_formula(NAME_values values, real3 wo, real3 wi) {
    return values.kd + values.ks * pow((1 - wo.z) * (1 - wi.z), values.n);
}

// (1 - cosine)^n. log1p keeps the small cosines that 1 - cosine would round away; unit vectors may
// reach beyond 1 by rounding.
real NAME_rim(real n, real cosine) { return real_exp(n * real_log1p(-smaller(cosine, 1))); }

// f times wi.z. wo and wi point away from the surface, z is the cosine to its normal; both are
// above the horizon.
real3 NAME_eval(const NAME_prepared* m, real3 wo, real3 wi) {
    return (m->kd + m->ks * (NAME_rim(m->n, wo.z) * NAME_rim(m->n, wi.z))) * wi.z;
}

// Density per solid angle with which sample, below, gives wi.
real NAME_pdf(const NAME_prepared* m, real3 wo, real3 wi) {
    real rim = (m->n + 1) * REAL_INV_TWO_PI * NAME_rim(m->n, wi.z);
    return m->choice.x * rim + m->choice.y * (wi.z * REAL_INV_PI);
}

// A direction wi from three numbers in [0, 1), its density and the weight f wi.z / pdf.
BrdfSample NAME_sample(const NAME_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    if (u.z < m->choice.x) {
        real z = -real_expm1(real_log(u.x) / (m->n + 1));  // 1 - u^(1 / (n + 1))
        sample.wi = (real3)(sqrt((1 - z) * (1 + z)) * real_circle(u.y), z);
    } else {
        sample.wi = cosine_hemisphere(u.xy);
    }
    real pdf = NAME_pdf(m, wo, sample.wi);
    if (!(sample.wi.z > 0 && pdf > 0)) return brdf_no_sample();
    sample.pdf = pdf;
    sample.weight = NAME_eval(m, wo, sample.wi) / pdf;
    return sample;
}
