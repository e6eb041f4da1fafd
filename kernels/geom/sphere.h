// SPDX-License-Identifier: Apache-2.0
// Eight spheres against a ray. The discriminant is formed from the distance of the centre to the
// ray, which does not cancel for small or far spheres: Haines, Guenther, Akenine-Moeller,
// "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019.
#ifndef LOBE_GEOM_SPHERE_H
#define LOBE_GEOM_SPHERE_H

#include "geom/lanes.h"
#include "geom/ray.h"

// Distance to the first meeting ahead for each lane, and the lanes met up to `reach`. The sphere
// that the ray starts from is met only at its far side.
lane_set test_spheres(global const LobeSphereLeaf* leaf, const Ray* ray, real reach,
                      real8* distance) {
    real3 d = ray->direction;
    real8 r = load_lanes(leaf->radius);
    real8 fx = (real8)(ray->origin.x) - load_lanes(leaf->centre[0]);
    real8 fy = (real8)(ray->origin.y) - load_lanes(leaf->centre[1]);
    real8 fz = (real8)(ray->origin.z) - load_lanes(leaf->centre[2]);
    real8 b = -fma(fx, (real8)(d.x), fma(fy, (real8)(d.y), fz * d.z));
    real8 lx = fma(b, (real8)(d.x), fx);
    real8 ly = fma(b, (real8)(d.y), fy);
    real8 lz = fma(b, (real8)(d.z), fz);
    real8 discriminant = r * r - fma(lx, lx, fma(ly, ly, lz * lz));
    real8 c = fma(fx, fx, fma(fy, fy, fz * fz)) - r * r;
    real8 q = b + copysign(sqrt(larger8(discriminant, (real8)(0))), b);
    real8 other = c / q;
    real8 near = smaller8(q, other);
    real8 far = larger8(q, other);
    mask8 outside = lanes_unlike(vload8(0, leaf->primitive), ray->from);
    *distance = ((near > 0) & outside) ? near : far;
    // From its own surface the ray meets a sphere again only if it runs inwards (b > 0).
    mask8 leaves = outside | (b > 0);
    return lanes_of((discriminant >= 0) & (*distance > 0) & (*distance <= reach) & leaves);
}

void nearest_sphere(global const LobeSphereLeaf* leaf, const Ray* ray, Hit* hit) {
    real8 distances;
    lane_set lanes = test_spheres(leaf, ray, hit->distance, &distances);
    if (!lanes) return;
    real distance[LOBE_WIDTH];
    vstore8(distances, 0, distance);
    for (; lanes; lanes = next_lanes(lanes)) {
        uint i = first_lane(lanes);
        uint primitive = leaf->primitive[i];
        if (distance[i] > hit->distance) continue;
        if (distance[i] == hit->distance && primitive > hit->primitive) continue;
        hit->distance = distance[i];
        hit->primitive = primitive;
    }
}

int any_sphere(global const LobeSphereLeaf* leaf, const Ray* ray) {
    real8 distances;
    lane_set lanes = test_spheres(leaf, ray, ray->reach, &distances);
    if (!lanes) return 0;
    return (lanes & lanes_of(lanes_unlike(vload8(0, leaf->primitive), ray->target))) != 0;
}

#endif
