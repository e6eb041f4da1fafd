// SPDX-License-Identifier: Apache-2.0
// Rays and what they meet, as `lobe bench` keeps them between kernels.
#ifndef LOBE_SHARED_BENCH_H
#define LOBE_SHARED_BENCH_H

#include "shared/layout.h"

typedef struct LobeBenchRay {
    float ox, oy, oz, reach;
    float dx, dy, dz, pad0;
    LobeUint from, target;  // primitives that it does not see
    LobeUint exists;        // 0: nothing to trace
    LobeUint pad1;
} LobeBenchRay;
LOBE_ASSERT_SIZE(LobeBenchRay, 48);

typedef struct LobeBenchHit {
    float distance, b1, b2;
    LobeUint primitive;  // LOBE_NONE: nothing was met
} LobeBenchHit;
LOBE_ASSERT_SIZE(LobeBenchHit, 16);

#endif
