// SPDX-License-Identifier: Apache-2.0
// Eight lanes at a time: loads, blends, and walking over the lanes that a test has left.
#ifndef LOBE_GEOM_LANES_H
#define LOBE_GEOM_LANES_H

#include "core/real.h"

// Lanes set in a mask, as a word to count down with `first_lane` and `next_lanes`.
#if defined(__AVX__) && !LOBE_DOUBLE && !defined(LOBE_PORTABLE_LANES)
typedef uint lane_set;
lane_set lanes_of(mask8 mask) { return (uint)__builtin_ia32_movmskps256(as_float8(mask)); }
uint first_lane(lane_set set) { return (uint)__builtin_ctz(set); }
#else
typedef ulong lane_set;  // bit 8 i for lane i
lane_set lanes_of(mask8 mask) { return as_ulong(convert_char8(mask)) & 0x0101010101010101ul; }
uint first_lane(lane_set set) { return (uint)popcount((set & (0ul - set)) - 1ul) >> 3; }
#endif
lane_set next_lanes(lane_set set) { return set & (set - 1); }

real8 load_lanes(global const float* row) { return to_real8(vload8(0, row)); }

// Lanes of `names` that differ from `name`, as a mask as wide as a real.
#if LOBE_DOUBLE
mask8 lanes_unlike(uint8 names, uint name) { return convert_long8(names != (uint8)(name)); }
#else
mask8 lanes_unlike(uint8 names, uint name) { return names != (uint8)(name); }
#endif

real8 larger8(real8 a, real8 b) { return a > b ? a : b; }
real8 smaller8(real8 a, real8 b) { return a < b ? a : b; }

#endif
