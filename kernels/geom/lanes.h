// SPDX-License-Identifier: Apache-2.0
// Eight lanes at a time: loads, blends, and walking over the lanes that a test has left.
#ifndef LOBE_GEOM_LANES_H
#define LOBE_GEOM_LANES_H

#include "core/real.h"

// Of kernels whose work-items compute with vectors of eight: a runtime that put several of them
// side by side on a CPU, as Intel's would, made gathers of their loads (rays five times as slow).
#define WIDE_WORK_ITEMS __attribute__((vec_type_hint(float8)))

// Lanes set in a mask, as a word to count down with `first_lane` and `next_lanes`.
#if defined(__AVX__) && !LOBE_DOUBLE && !defined(LOBE_PORTABLE_LANES)
typedef uint lane_set;
lane_set lanes_of(mask8 mask) { return (uint)__builtin_ia32_movmskps256(as_float8(mask)); }
uint first_lane(lane_set set) { return (uint)__builtin_ctz(set); }
void fetch_line(ulong address) { __builtin_prefetch((const void*)address); }
#else
typedef ulong lane_set;  // bit 8 i for lane i
lane_set lanes_of(mask8 mask) { return as_ulong(convert_char8(mask)) & 0x0101010101010101ul; }
uint first_lane(lane_set set) { return (uint)popcount((set & (0ul - set)) - 1ul) >> 3; }
void fetch_line(ulong address) {}  // OpenCL's own prefetch does nothing on CPUs
#endif
lane_set next_lanes(lane_set set) { return set & (set - 1); }

real8 load_lanes(global const float* row) { return to_real8(vload8(0, row)); }

// Masks as wide as a real from masks as wide as a word, and back.
#if LOBE_DOUBLE
mask8 wide_mask(int8 mask) { return convert_long8(mask); }
int8 narrow_mask(mask8 mask) { return convert_int8(mask); }
#else
mask8 wide_mask(int8 mask) { return mask; }
int8 narrow_mask(mask8 mask) { return mask; }
#endif

// Lanes of `names` that differ from `name`, or are above it.
mask8 lanes_unlike(uint8 names, uint name) { return wide_mask(names != (uint8)(name)); }
mask8 lanes_above(uint8 names, uint name) { return wide_mask(names > (uint8)(name)); }

real8 larger8(real8 a, real8 b) { return a > b ? a : b; }
real8 smaller8(real8 a, real8 b) { return a < b ? a : b; }

real largest_lane(real8 x) {
    real largest = x.s0;
    largest = x.s1 > largest ? x.s1 : largest;
    largest = x.s2 > largest ? x.s2 : largest;
    largest = x.s3 > largest ? x.s3 : largest;
    largest = x.s4 > largest ? x.s4 : largest;
    largest = x.s5 > largest ? x.s5 : largest;
    largest = x.s6 > largest ? x.s6 : largest;
    return x.s7 > largest ? x.s7 : largest;
}

#endif
