// SPDX-License-Identifier: Apache-2.0
// The addressed random numbers for arrays of addresses.
#include "lobe_scene.h"

#include "core/rng.h"

#if LOBE_ABREAST == 1
kernel void rng_pcg4d(global const uint* in, global uint* out) {
    uint i = get_global_id(0);
    uint4 v = vload4(i, in);
    FourWords words = pcg4d(v.x, v.y, v.z, v.w);
    vstore4((uint4)(words.x, words.y, words.z, words.w), i, out);
}

kernel void rng_unit_interval(global const uint* bits, global real* out) {
    out[get_global_id(0)] = unit_interval(bits[get_global_id(0)]);
}

// Point i of the two coordinates without any scrambling.
kernel void rng_plain_sobol(global const uint* points, global uint* out) {
    uint i = get_global_id(0), point = points[i];
    vstore2((uint2)(reverse_bits(point), reverse_bits(sobol_second_reversed(point))), i, out);
}

// in: key (2), pair of dimensions, point
kernel void rng_scrambled_sobol(global const uint* in, global uint* out) {
    uint i = get_global_id(0);
    uint4 v = vload4(i, in);
    WordPair words = scrambled_sobol(v.x, v.y, v.z, v.w);
    vstore2((uint2)(words.x, words.y), i, out);
}
#endif

// in: pixel, sample, pair of dimensions, spare. out: the pair, then the independent number
kernel void rng_numbers(uint seed0, uint seed1, global const uint* in, global real* out) {
    uint i = get_global_id(0);
    uint4 v = vload4(i, in);
    uint lane = v.y % LOBE_ABREAST;
    Sampler sampler = make_sampler((uint2)(seed0, seed1), v.x, v.y - lane);
    NumberPairs pairs = pairs_of_numbers(&sampler, v.z);
    real hashed[LOBE_ABREAST];
    hashed_numbers(&sampler, v.z, hashed);
    vstore2(number_pair(&pairs, lane), 0, out + 3 * i);
    out[3 * i + 2] = hashed[lane];
}
