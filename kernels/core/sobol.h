// SPDX-License-Identifier: Apache-2.0
// The first two dimensions of Sobol's sequence with Owen scrambling by hashing: Laine and Karras,
// "Stratified Sampling for Stochastic Transparency", 2011; Burley, "Practical Hash-based Owen
// Scrambling", JCGT 9(4), 2020.
#ifndef LOBE_CORE_SOBOL_H
#define LOBE_CORE_SOBOL_H

#include "core/abreast.h"

uints reverse_bits(uints x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

// A bijection of 32 bits that looks random in all of them (Wellons, hash-prospector, "lowbias32").
uints mix_bits(uints x) {
    x ^= x >> 16;
    x *= 0x21f0aaadu;
    x ^= x >> 15;
    x *= 0x735a2d97u;
    return x ^ (x >> 15);
}

// A random permutation in which a bit depends on itself and the bits below: on bit-reversed
// fractions it is a nested uniform scramble. Constants by Vegdahl, "Building a Better LK Hash".
uints laine_karras(uints x, uints seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    return x ^ (x * 0x53a22864u);
}

// Bit-reversed second Sobol coordinate of point i. Its generator is Pascal's triangle modulo two,
// which by Lucas is "xor of all bits whose position contains mine": five shifts do that.
uints sobol_second_reversed(uints i) {
    i ^= (i & 0xaaaaaaaau) >> 1;
    i ^= (i & 0xccccccccu) >> 2;
    i ^= (i & 0xf0f0f0f0u) >> 4;
    i ^= (i & 0xff00ff00u) >> 8;
    return i ^ (i >> 16);
}

typedef struct {
    uints x, y;
} WordPair;

// Two scrambled coordinates as 32-bit fractions. The order of the points is shuffled for each pair
// of dimensions, which decorrelates pairs that share a point number.
WordPair scrambled_sobol(uints key_x, uints key_y, uint pair, uints point) {
    uints seed = mix_bits(key_x + pair * 0x9e3779b9u);
    uints seed_x = mix_bits(seed ^ key_y);
    uints seed_y = mix_bits(seed_x + 0x9e3779b9u);
    uints i = reverse_bits(laine_karras(reverse_bits(point), seed));
    WordPair words;
    words.x = reverse_bits(laine_karras(i, seed_x));
    words.y = reverse_bits(laine_karras(sobol_second_reversed(i), seed_y));
    return words;
}

#endif
