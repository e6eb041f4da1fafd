// SPDX-License-Identifier: Apache-2.0
// Circles about any axis, and what of them lies above the horizon.
#ifndef LOBE_BRDF_ARC_H
#define LOBE_BRDF_ARC_H

#include "brdf/lobe.h"

// Shorter arcs count as this: densities stay bounded, and the few samples that fall beside the true
// arc are lost below the horizon.
#define LOBE_SHORTEST_ARC R(1e-3)

// The share above the horizon of the circle at p about an axis, which may point below it: as
// lobe_visible_arc, but less than half where the circle's centre lies below the horizon.
real visible_arc(LobePoint p, real3 axis) {
    real across = axis.x * axis.x + axis.y * axis.y;
    real beyond = p.x < R(0.5) ? p.x * (2 - p.x) - axis.z * axis.z : across - p.t * p.t;
    real height = p.t * axis.z;
    if (!(beyond > 0)) return height > 0 ? 1 : LOBE_SHORTEST_ARC;
    real turns = 2 * real_angle(fabs(height), sqrt(beyond));
    return larger(R(0.5) + (height > 0 ? turns : -turns), LOBE_SHORTEST_ARC);
}

#endif
