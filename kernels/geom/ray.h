// SPDX-License-Identifier: Apache-2.0
// Rays, what they meet, and the scene's buffers that they travel through.
#ifndef LOBE_GEOM_RAY_H
#define LOBE_GEOM_RAY_H

#include "core/vec.h"
#include "shared/types.h"

// A ray of unit direction. It does not see the primitive it starts `from` (a sphere: its near
// side), nor as a shadow ray the `target` it is sent to: comparing names needs no epsilon.
typedef struct {
    real3 origin, direction;
    real reach;  // largest distance of interest
    uint from, target;
} Ray;

// The nearest meeting: distance, barycentric weights of corners 1 and 2 (triangles), and which.
typedef struct {
    real distance, b1, b2;
    uint primitive;  // LOBE_NONE: nothing was met
} Hit;

// What traversal reads.
typedef struct {
    global const LobeNode* nodes;
    global const LobeTriangleLeaf* triangle_leaves;
    global const LobeSphereLeaf* sphere_leaves;
} Geometry;

Ray make_ray(real3 origin, real3 direction, uint from) {
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    ray.reach = REAL_HUGE;
    ray.from = from;
    ray.target = LOBE_NONE;
    return ray;
}

Hit no_hit(void) {
    Hit hit;
    hit.distance = REAL_HUGE;
    hit.b1 = hit.b2 = 0;
    hit.primitive = LOBE_NONE;
    return hit;
}

#endif
