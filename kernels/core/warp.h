// SPDX-License-Identifier: Apache-2.0
// Maps from the unit square to the domains that a path tracer samples. Each u lies in [0, 1).
#ifndef LOBE_CORE_WARP_H
#define LOBE_CORE_WARP_H

#include "core/math.h"
#include "core/vec.h"

// A point of the square mapped to the unit disk: concentric squares to concentric circles, which
// keeps neighbours together (P. Shirley, K. Chiu, "A low distortion map between disk and square",
// 1997). Gives the point and, in z, its radius with a sign. The shift by half a step of u makes
// the square symmetric and keeps the rim out: |radius| <= 1 - REAL_EPSILON.
real3 concentric_disk(real2 u) {
    real a = 2 * u.x - 1 + REAL_EPSILON;
    real b = 2 * u.y - 1 + REAL_EPSILON;
    int wide = fabs(a) > fabs(b);
    real radius = wide ? a : b;
    real ratio = radius == 0 ? 0 : (wide ? b : a) / radius;
    real2 p = radius * real_circle_octant(R(0.125) * ratio);
    return wide ? (real3)(p.x, p.y, radius) : (real3)(p.y, p.x, radius);
}

// Uniform over the unit disk: density 1 / pi per area.
real2 uniform_disk(real2 u) { return concentric_disk(u).xy; }

// Directions about +z with density cos / pi: a disk lifted to the hemisphere (Malley). The cosine
// comes from the radius itself and is never 0.
real3 cosine_hemisphere(real2 u) {
    real3 p = concentric_disk(u);
    real r = fabs(p.z);
    return (real3)(p.x, p.y, sqrt((1 - r) * (1 + r)));
}

// Directions within a cone about +z, given 1 - cos of its half angle: density 1 / (2 pi (1 - cos)).
// Forming all from 1 - cos keeps cones of 1e-10 rad exact.
real3 uniform_cone(real2 u, real one_minus_cos) {
    real v = u.x * one_minus_cos;
    real2 p = sqrt(v * (2 - v)) * real_circle(u.y);
    return (real3)(p.x, p.y, 1 - v);
}

// Uniform over all directions: density 1 / (4 pi).
real3 uniform_sphere(real2 u) { return uniform_cone(u, 2); }

// Weights of two corners of a triangle (the third has the rest), uniform over its area: the square
// folded along its diagonal (E. Heitz, "A low-distortion map between triangle and square", 2019).
real2 uniform_triangle(real2 u) {
    return u.x < u.y ? (real2)(R(0.5) * u.x, u.y - R(0.5) * u.x)
                     : (real2)(u.x - R(0.5) * u.y, R(0.5) * u.y);
}

#endif
