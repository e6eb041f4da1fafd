// SPDX-License-Identifier: Apache-2.0
// From a material's number to its model's functions. Only the models that lobe_scene.h lists in
// LOBE_BRDFS exist here; a material knows its model by the place in that list.
#ifndef LOBE_BRDF_DISPATCH_H
#define LOBE_BRDF_DISPATCH_H

#include "brdf/brdf.h"
#include "core/warp.h"

#define LOBE_MODEL(NAME) LOBE_MODEL_##NAME,
enum { LOBE_BRDFS(LOBE_MODEL) LOBE_MODEL_COUNT };

// The build stops here if a model's prepared form outgrows its room.
#define LOBE_FITS(NAME) \
    typedef char NAME##_prepared_fits[sizeof(NAME##_prepared) <= LOBE_PREPARED_BYTES ? 1 : -1];
LOBE_BRDFS(LOBE_FITS)

// All that a path asks of a material at one point.
typedef struct {
    real3 reflected;  // f cos theta_i towards the light, 0 if there is no such direction
    real pdf;         // density with which `next` could have gone there
    BrdfSample next;  // where the path goes on
} Scattering;

#define LOBE_PREPARE(NAME)                                                      \
    case LOBE_MODEL_##NAME:                                                     \
        *(global NAME##_prepared*)prepared = NAME##_prepare(NAME##_load(rows)); \
        return 1;

// Writes the prepared form of a material. Returns 0 if its model is not compiled in.
int prepare_material(uint model, global const LobeRow* rows, global uchar* prepared) {
    switch (model) { LOBE_BRDFS(LOBE_PREPARE) }
    return 0;
}

#define LOBE_SCATTER(NAME)                                                     \
    case LOBE_MODEL_##NAME: {                                                  \
        NAME##_prepared m = *(global const NAME##_prepared*)prepared;          \
        LOBE_BRDF_ATTACH(NAME, m, tables)                                      \
        if (wi.z > 0) {                                                        \
            scattering.reflected = NAME##_eval(&m, wo, wi);                    \
            scattering.pdf = NAME##_pdf(&m, wo, wi);                           \
        }                                                                      \
        if (LOBE_COSINE_DIRECTIONS) {                                          \
            scattering.next.weight =                                           \
                NAME##_eval(&m, wo, scattering.next.wi) / scattering.next.pdf; \
        } else {                                                               \
            scattering.next = NAME##_sample(&m, wo, u);                        \
        }                                                                      \
        break;                                                                 \
    }

// One visit to the material answers both questions: what goes towards wi (asked only if wi.z > 0)
// and where to go next. wo.z > 0; both directions in the shading frame. With LOBE_COSINE_DIRECTIONS
// every model is sampled by the cosine alone: delta lobes are then never met, and perfect mirrors
// are black.
Scattering scatter(uint model, global const uchar* prepared, LobeTables tables, real3 wo, real3 wi,
                   real3 u) {
    Scattering scattering;
    scattering.reflected = (real3)(0);
    scattering.pdf = 0;
    scattering.next = brdf_no_sample();
    if (LOBE_COSINE_DIRECTIONS) {
        scattering.next.wi = cosine_hemisphere(u.xy);
        scattering.next.pdf = REAL_INV_PI * scattering.next.wi.z;
    }
    switch (model) { LOBE_BRDFS(LOBE_SCATTER) }
    if (LOBE_COSINE_DIRECTIONS) scattering.pdf = REAL_INV_PI * larger(wi.z, 0);
    return scattering;
}

#endif
