// SPDX-License-Identifier: Apache-2.0
// Asks any model that keeps the contract of brdf/brdf.h for arrays of inputs. The generated
// "probe_brdf.h" includes the model, defines LOBE_PROBE_BRDF as its name and LOBE_PROBE_FORMULA as
// whether it prints its formula. Vectors are three numbers each; `rows` holds one parameter set
// after the other, the set of item i is i / items_per_set.
#include "brdf/brdf.h"
#include "probe_brdf.h"

#define PROBE_JOIN(a, b) a##b
#define PROBE_NAME(model, function) PROBE_JOIN(model, function)
#define PROBE(function) PROBE_NAME(LOBE_PROBE_BRDF, function)
#define PROBE_ATTACH(model, m, tables) LOBE_BRDF_ATTACH(model, m, tables)

PROBE(_values)
probe_values(global const LobeRow* rows, uint rows_per_set, uint items_per_set) {
    uint set = (uint)get_global_id(0) / items_per_set;
    return PROBE(_load)(rows + set * rows_per_set);
}

// out: f cos theta_i (3), pdf
kernel void brdf_eval(global const LobeRow* rows, uint rows_per_set, uint items_per_set,
                      global const float* tables, global const real* wo, global const real* wi,
                      global real* out) {
    uint i = get_global_id(0);
    PROBE(_prepared) m = PROBE(_prepare)(probe_values(rows, rows_per_set, items_per_set));
    PROBE_ATTACH(LOBE_PROBE_BRDF, m, tables)
    real3 f = PROBE(_eval)(&m, vload3(i, wo), vload3(i, wi));
    vstore3(f, 0, out + 4 * i);
    out[4 * i + 3] = PROBE(_pdf)(&m, vload3(i, wo), vload3(i, wi));
}

// out: wi (3), pdf, weight (3), delta
kernel void brdf_sample(global const LobeRow* rows, uint rows_per_set, uint items_per_set,
                        global const float* tables, global const real* wo, global const real* u,
                        global real* out) {
    uint i = get_global_id(0);
    PROBE(_prepared) m = PROBE(_prepare)(probe_values(rows, rows_per_set, items_per_set));
    PROBE_ATTACH(LOBE_PROBE_BRDF, m, tables)
    BrdfSample sample = PROBE(_sample)(&m, vload3(i, wo), vload3(i, u));
    vstore3(sample.wi, 0, out + 8 * i);
    out[8 * i + 3] = sample.pdf;
    vstore3(sample.weight, 0, out + 8 * i + 4);
    out[8 * i + 7] = sample.delta;
}

#if LOBE_PROBE_FORMULA
// out: f (3) as the source prints it
kernel void brdf_formula(global const LobeRow* rows, uint rows_per_set, uint items_per_set,
                         global const real* wo, global const real* wi, global real* out) {
    uint i = get_global_id(0);
    PROBE(_values) values = probe_values(rows, rows_per_set, items_per_set);
    vstore3(PROBE(_formula)(values, vload3(i, wo), vload3(i, wi)), i, out);
}
#endif

// A set an item. out: its claims, bytes of the prepared form
kernel void brdf_claims(global const LobeRow* rows, uint rows_per_set, global uint* out) {
    uint i = get_global_id(0);
    out[2 * i] = PROBE(_claims)(PROBE(_load)(rows + i * rows_per_set));
    out[2 * i + 1] = sizeof(PROBE(_prepared));
}
