// SPDX-License-Identifier: Apache-2.0
// An orthonormal basis about a normal, and directions into and out of it.
#ifndef LOBE_CORE_FRAME3_H
#define LOBE_CORE_FRAME3_H

#include "core/vec.h"

typedef struct {
    real3 t, b, n;  // two tangents and the unit normal, right-handed
} Frame3;

// Without branch and without a bad pole: T. Duff et al., "Building an orthonormal basis,
// revisited", JCGT 6(1), 2017.
Frame3 make_frame3(real3 n) {
    real side = copysign((real)1, n.z);
    real a = -1 / (side + n.z);
    real b = n.x * n.y * a;
    Frame3 frame;
    frame.t = (real3)(fma(side * n.x * n.x, a, 1), side * b, -side * n.x);
    frame.b = (real3)(b, fma(n.y * n.y, a, side), -n.y);
    frame.n = n;
    return frame;
}

real3 to_local(const Frame3* frame, real3 v) {
    return (real3)(dot(v, frame->t), dot(v, frame->b), dot(v, frame->n));
}

real3 to_world(const Frame3* frame, real3 v) {
    return v.x * frame->t + v.y * frame->b + v.z * frame->n;
}

#endif
