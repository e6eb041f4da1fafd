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

// Where in the random numbers one sample of one pixel stands.
typedef struct {
    uint2 key;   // of (seed, pixel, replicate)
    uint point;  // place in the replicate's own sequence
} Sampler;

// Four well-mixed words from four: pcg4d of Jarzynski and Olano, "Hash Functions for GPU
// Rendering", JCGT 9(3), 2020.
uint4 pcg4d(uint4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// The upper 24 bits as a number in [0, 1 - 2^-24]: exact, never 1.
real unit_interval(uint bits) { return (real)(bits >> 8) * R(5.9604644775390625e-8); }

// The sampler of sample `sample` of pixel number `pixel` (of the whole film).
Sampler make_sampler(uint2 seed, uint pixel, uint sample) {
    Sampler sampler;
    sampler.key = pcg4d((uint4)(seed.x, seed.y, pixel, sample % LOBE_REPLICATES)).xy;
    sampler.point = sample / LOBE_REPLICATES;
    return sampler;
}

// A point in [0,1)^2 for one dimension pair: Owen-scrambled Sobol, padded (shuffled for each pair),
// or independent numbers by hashing.
real2 pair_of_numbers(const Sampler* sampler, uint dimension) {
    uint2 bits = LOBE_INDEPENDENT_NUMBERS
                     ? pcg4d((uint4)(sampler->key, sampler->point, dimension)).yz
                     : scrambled_sobol(sampler->key, dimension, sampler->point);
    return (real2)(unit_interval(bits.x), unit_interval(bits.y));
}

// One independent number in [0,1) for a dimension that low discrepancy does not serve.
real hashed_number(const Sampler* sampler, uint dimension) {
    return unit_interval(pcg4d((uint4)(sampler->key, sampler->point, dimension)).x);
}

// Number of the pair of dimensions `purpose` at scattering event `depth`.
uint bounce_dimension(uint depth, uint purpose) {
    return DIMENSION_BOUNCE + depth * DIMENSIONS_PER_BOUNCE + purpose;
}

#endif
