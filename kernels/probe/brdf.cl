// SPDX-License-Identifier: Apache-2.0
// Asks any model that keeps the contract of brdf/brdf.h: its prepare, eval, pdf and sample for
// arrays of inputs. The generated "probe_brdf.h" includes the model and defines LOBE_PROBE_BRDF as
// its name. Vectors are three numbers each; `rows` holds one parameter set after the other, the
// set of item i is i / items_per_set.
#include "brdf/brdf.h"
#include "probe_brdf.h"

#define PROBE_JOIN(a, b) a##b
#define PROBE_NAME(model, function) PROBE_JOIN(model, function)
#define PROBE(function) PROBE_NAME(LOBE_PROBE_BRDF, function)

PROBE(_prepared) probe_prepare(global const LobeRow* rows, uint rows_per_set, uint items_per_set) {
    uint set = (uint)get_global_id(0) / items_per_set;
    return PROBE(_prepare)(PROBE(_load)(rows + set * rows_per_set));
}

// out: f cos theta_i (3), pdf
kernel void brdf_eval(global const LobeRow* rows, uint rows_per_set, uint items_per_set,
                      global const real* wo, global const real* wi, global real* out) {
    uint i = get_global_id(0);
    PROBE(_prepared) m = probe_prepare(rows, rows_per_set, items_per_set);
    real3 f = PROBE(_eval)(&m, vload3(i, wo), vload3(i, wi));
    vstore3(f, 0, out + 4 * i);
    out[4 * i + 3] = PROBE(_pdf)(&m, vload3(i, wo), vload3(i, wi));
}

// out: wi (3), pdf, weight (3), delta
kernel void brdf_sample(global const LobeRow* rows, uint rows_per_set, uint items_per_set,
                        global const real* wo, global const real* u, global real* out) {
    uint i = get_global_id(0);
    PROBE(_prepared) m = probe_prepare(rows, rows_per_set, items_per_set);
    BrdfSample sample = PROBE(_sample)(&m, vload3(i, wo), vload3(i, u));
    vstore3(sample.wi, 0, out + 8 * i);
    out[8 * i + 3] = sample.pdf;
    vstore3(sample.weight, 0, out + 8 * i + 4);
    out[8 * i + 7] = sample.delta;
}

// out: bytes of the prepared form
kernel void brdf_size(global uint* out) { *out = sizeof(PROBE(_prepared)); }
