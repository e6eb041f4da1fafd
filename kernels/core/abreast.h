// SPDX-License-Identifier: Apache-2.0
// The samples that a work-item takes side by side, one a lane. What costs the same for all of them,
// random numbers above all, is computed for all lanes at once: on CPUs, whose compilers make
// vectors of what is written as vectors. GPUs make their own out of work-items, and take one lane.
// The bits do not depend on it.
#ifndef LOBE_CORE_ABREAST_H
#define LOBE_CORE_ABREAST_H

#include "core/real.h"

#ifndef LOBE_ABREAST
#define LOBE_ABREAST 1  // or 8
#endif

#if LOBE_ABREAST == 8
typedef uint8 uints;
typedef real8 reals;
uints lane_numbers(void) { return (uints)(0, 1, 2, 3, 4, 5, 6, 7); }
void store_reals(reals lanes, real* to) { vstore8(lanes, 0, to); }
reals to_reals(uints lanes) { return to_real8(lanes); }
#else
typedef uint uints;
typedef real reals;
uints lane_numbers(void) { return 0; }
void store_reals(reals lane, real* to) { *to = lane; }
reals to_reals(uints lane) { return (real)lane; }
#endif

// A set of lanes is a word with their bits.
#define LOBE_ALL_LANES ((1u << LOBE_ABREAST) - 1)
uint lowest_lane(uint set) { return 31 - clz(set & (0u - set)); }
uint without_lowest(uint set) { return set & (set - 1); }

#endif
