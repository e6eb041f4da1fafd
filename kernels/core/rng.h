// SPDX-License-Identifier: Apache-2.0
// Random numbers by address: a value depends on (seed, pixel, sample, dimension) and on nothing
// else, so launches, tiles, resumed renders and left-out code cannot change a sample.
#ifndef LOBE_CORE_RNG_H
#define LOBE_CORE_RNG_H

#include "core/sobol.h"
#include "shared/frame.h"

// What each pair of numbers of a path is for. Pairs of a bounce follow DIMENSION_BOUNCE.
#define DIMENSION_FILTER 0u
#define DIMENSION_LENS 1u
#define DIMENSION_BOUNCE 2u
#define DIMENSION_LIGHT 0u     // point on the light
#define DIMENSION_BRDF 1u      // direction
#define DIMENSION_CHOICE 2u    // which light, which lobe
#define DIMENSION_SURVIVAL 3u  // Russian roulette
#define DIMENSIONS_PER_BOUNCE 4u

// Where in the random numbers the samples of the lanes stand.
typedef struct {
    uints key_x, key_y;  // of (seed, pixel, replicate)
    uints point;         // place in the replicate's own sequence
} Sampler;

typedef struct {
    uints x, y, z, w;
} FourWords;

// Four well-mixed words from four: pcg4d of Jarzynski and Olano, "Hash Functions for GPU
// Rendering", JCGT 9(3), 2020.
FourWords pcg4d(uints x, uints y, uints z, uints w) {
    FourWords v;
    v.x = x * 1664525u + 1013904223u;
    v.y = y * 1664525u + 1013904223u;
    v.z = z * 1664525u + 1013904223u;
    v.w = w * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v.x ^= v.x >> 16;
    v.y ^= v.y >> 16;
    v.z ^= v.z >> 16;
    v.w ^= v.w >> 16;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// The upper 24 bits as numbers in [0, 1 - 2^-24]: exact, never 1.
reals unit_interval(uints bits) { return to_reals(bits >> 8) * R(5.9604644775390625e-8); }

// The sampler of the samples from `first` on, one a lane, of pixel number `pixel` (of the whole
// film).
Sampler make_sampler(uint2 seed, uint pixel, uint first) {
    uints sample = first + lane_numbers();
    FourWords words =
        pcg4d((uints)(seed.x), (uints)(seed.y), (uints)(pixel), sample % LOBE_REPLICATES);
    Sampler sampler;
    sampler.key_x = words.x;
    sampler.key_y = words.y;
    sampler.point = sample / LOBE_REPLICATES;
    return sampler;
}

// A point in [0,1)^2 for each lane.
typedef struct {
    real x[LOBE_ABREAST], y[LOBE_ABREAST];
} NumberPairs;

real2 number_pair(const NumberPairs* pairs, uint lane) {
    return (real2)(pairs->x[lane], pairs->y[lane]);
}

// The points for one dimension pair: Owen-scrambled Sobol, padded (shuffled for each pair), or
// independent numbers by hashing.
NumberPairs pairs_of_numbers(const Sampler* s, uint dimension) {
    WordPair bits;
    if (LOBE_INDEPENDENT_NUMBERS) {
        FourWords words = pcg4d(s->key_x, s->key_y, s->point, (uints)(dimension));
        bits.x = words.y;
        bits.y = words.z;
    } else {
        bits = scrambled_sobol(s->key_x, s->key_y, dimension, s->point);
    }
    NumberPairs pairs;
    store_reals(unit_interval(bits.x), pairs.x);
    store_reals(unit_interval(bits.y), pairs.y);
    return pairs;
}

// An independent number in [0,1) for each lane, for a dimension that low discrepancy does not
// serve.
void hashed_numbers(const Sampler* s, uint dimension, real* numbers) {
    store_reals(unit_interval(pcg4d(s->key_x, s->key_y, s->point, (uints)(dimension)).x), numbers);
}

// Number of the pair of dimensions `purpose` at scattering event `depth`.
uint bounce_dimension(uint depth, uint purpose) {
    return DIMENSION_BOUNCE + depth * DIMENSIONS_PER_BOUNCE + purpose;
}

#endif
