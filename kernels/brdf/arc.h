// SPDX-License-Identifier: Apache-2.0
// Circles about any axis, and what of them lies above the horizon: as lobe_visible_arc, for axes
// that may point below it too.
//
// A point of the circle at p, at the azimuth phi from its highest one, has the height
// z = p.t axis.z + w cos phi, w the product of the sines. So the arc above the horizon ends where
// w cos phi = -p.t axis.z, and has w sin phi = sqrt(beyond) there, beyond = w^2 - (p.t axis.z)^2.
#ifndef LOBE_BRDF_ARC_H
#define LOBE_BRDF_ARC_H

#include "brdf/lobe.h"

// Shorter arcs count as this: densities stay bounded, and the few samples that fall beside the true
// arc are lost below the horizon.
#define LOBE_SHORTEST_ARC R(1e-3)

// The share of the circle above the horizon, from `height` = p.t axis.z and `beyond`.
real arc_share(real height, real beyond) {
    if (!(beyond > 0)) return height > 0 ? 1 : LOBE_SHORTEST_ARC;
    if (height > 0) return R(0.5) + 2 * real_angle(height, sqrt(beyond));
    return larger(2 * real_angle(sqrt(beyond), -height), LOBE_SHORTEST_ARC);
}

real visible_arc(LobePoint p, real3 axis) {
    real across = axis.x * axis.x + axis.y * axis.y;
    real beyond = p.x < R(0.5) ? p.x * (2 - p.x) - axis.z * axis.z : across - p.t * p.t;
    return arc_share(p.t * axis.z, beyond);
}

// The same for the circle through wi, wi.z > 0, given side = w sin phi at wi. A short arc ends near
// wi: beyond = z (z - 2 height) + side^2 is a sum of nothing negative where the height is.
real arc_through(real3 wi, LobePoint p, real3 axis, real side) {
    real height = p.t * axis.z;
    if (height > 0) return visible_arc(p, axis);
    return arc_share(height, fma(wi.z, wi.z - 2 * height, side * side));
}

#endif
