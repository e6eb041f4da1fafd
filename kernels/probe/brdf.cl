// SPDX-License-Identifier: Apache-2.0
// Asks any model that keeps the contract of brdf/brdf.h for arrays of inputs. The generated
// "probe_brdf.h" includes the model, defines LOBE_PROBE_BRDF as its name and LOBE_PROBE_FORMULA as
// whether it prints its formula. Vectors are three numbers each; `rows` holds one set of parameters
// after the other, and item i is asked of set set_of[i].
#include "brdf/brdf.h"
#include "probe_brdf.h"

#define PROBE_JOIN(a, b) a##b
#define PROBE_NAME(model, function) PROBE_JOIN(model, function)
#define PROBE(function) PROBE_NAME(LOBE_PROBE_BRDF, function)
#define PROBE_ATTACH(model, m, tables) LOBE_BRDF_ATTACH(model, m, tables)

// A set an item: writes its prepared form. out: its claims, bytes of the prepared form
kernel void brdf_prepare(global const LobeRow* rows, uint rows_per_set, global uchar* prepared,
                         global uint* out) {
    uint i = get_global_id(0);
    PROBE(_values) values = PROBE(_load)(rows + i * rows_per_set);
    *(global PROBE(_prepared)*)(prepared + i * LOBE_PREPARED_BYTES) = PROBE(_prepare)(values);
    out[2 * i] = PROBE(_claims)(values);
    out[2 * i + 1] = sizeof(PROBE(_prepared));
}

PROBE(_prepared) probe_prepared(global const uchar* prepared, uint set, LobeTables tables) {
    PROBE(_prepared) m = *(global const PROBE(_prepared)*)(prepared + set * LOBE_PREPARED_BYTES);
    PROBE_ATTACH(LOBE_PROBE_BRDF, m, tables)
    return m;
}

// out: f cos theta_i (3), pdf
kernel void brdf_eval(global const uchar* prepared, global const float* tables,
                      global const uint* set_of, global const real* wo, global const real* wi,
                      global real* out) {
    uint i = get_global_id(0);
    PROBE(_prepared) m = probe_prepared(prepared, set_of[i], tables);
    real3 f = PROBE(_eval)(&m, vload3(i, wo), vload3(i, wi));
    vstore3(f, 0, out + 4 * i);
    out[4 * i + 3] = PROBE(_pdf)(&m, vload3(i, wo), vload3(i, wi));
}

// out: wi (3), pdf, weight (3), delta
kernel void brdf_sample(global const uchar* prepared, global const float* tables,
                        global const uint* set_of, global const real* wo, global const real* u,
                        global real* out) {
    uint i = get_global_id(0);
    PROBE(_prepared) m = probe_prepared(prepared, set_of[i], tables);
    BrdfSample sample = PROBE(_sample)(&m, vload3(i, wo), vload3(i, u));
    vstore3(sample.wi, 0, out + 8 * i);
    out[8 * i + 3] = sample.pdf;
    vstore3(sample.weight, 0, out + 8 * i + 4);
    out[8 * i + 7] = sample.delta;
}

#if LOBE_PROBE_FORMULA
// out: f (3) as the source prints it
kernel void brdf_formula(global const LobeRow* rows, uint rows_per_set, global const uint* set_of,
                         global const real* wo, global const real* wi, global real* out) {
    uint i = get_global_id(0);
    PROBE(_values) values = PROBE(_load)(rows + set_of[i] * rows_per_set);
    vstore3(PROBE(_formula)(values, vload3(i, wo), vload3(i, wi)), i, out);
}
#endif
