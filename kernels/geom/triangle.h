// SPDX-License-Identifier: Apache-2.0
// Eight triangles against a ray, watertight: Woop, Benthin, Wald, "Watertight Ray/Triangle
// Intersection", JCGT 2(1), 2013.
//
// A shared edge gives the two triangles edge functions that are exact negatives of each other,
// provided that a*b - c*d is two rounded products and one rounded difference: fusing one of the
// products (FP_CONTRACT ON) leaks one ray in a hundred. An edge function of zero counts as inside
// for both signs, so no second pass in double is needed.
#ifndef LOBE_GEOM_TRIANGLE_H
#define LOBE_GEOM_TRIANGLE_H

#include "geom/lanes.h"
#include "geom/ray.h"

// The ray's own axes: kz is where it runs fastest; shear moves it onto that axis.
typedef struct {
    int kx, ky, kz;
    real ox, oy, oz;
    real sx, sy, sz;
} Shear;

real component(real3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

Shear make_shear(const Ray* ray) {
    real3 size = fabs(ray->direction);
    Shear s;
    s.kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    s.kx = s.kz == 2 ? 0 : s.kz + 1;
    s.ky = s.kx == 2 ? 0 : s.kx + 1;
    real z = component(ray->direction, s.kz);
    s.sx = component(ray->direction, s.kx) / z;
    s.sy = component(ray->direction, s.ky) / z;
    s.sz = 1 / z;
    s.ox = component(ray->origin, s.kx);
    s.oy = component(ray->origin, s.ky);
    s.oz = component(ray->origin, s.kz);
    return s;
}

// Edge functions of eight triangles (proportional to the barycentric weights of corners 0, 1, 2),
// distances, and the lanes that are met beyond 0 and up to a reach.
typedef struct {
    real8 u, v, w, determinant, distance;
    lane_set lanes;
} TriangleTest;

TriangleTest test_triangles(global const LobeTriangleLeaf* leaf, const Ray* ray, const Shear* s,
                            real reach) {
    real8 az = load_lanes(leaf->vertex[0][s->kz]) - s->oz;
    real8 bz = load_lanes(leaf->vertex[1][s->kz]) - s->oz;
    real8 cz = load_lanes(leaf->vertex[2][s->kz]) - s->oz;
    real8 ax = fma((real8)(-s->sx), az, load_lanes(leaf->vertex[0][s->kx]) - s->ox);
    real8 ay = fma((real8)(-s->sy), az, load_lanes(leaf->vertex[0][s->ky]) - s->oy);
    real8 bx = fma((real8)(-s->sx), bz, load_lanes(leaf->vertex[1][s->kx]) - s->ox);
    real8 by = fma((real8)(-s->sy), bz, load_lanes(leaf->vertex[1][s->ky]) - s->oy);
    real8 cx = fma((real8)(-s->sx), cz, load_lanes(leaf->vertex[2][s->kx]) - s->ox);
    real8 cy = fma((real8)(-s->sy), cz, load_lanes(leaf->vertex[2][s->ky]) - s->oy);
    TriangleTest test;
    test.u = cx * by - cy * bx;
    test.v = ax * cy - ay * cx;
    test.w = bx * ay - by * ax;
    test.determinant = test.u + test.v + test.w;
    real8 scaled = fma(test.u, az, fma(test.v, bz, test.w * cz)) * s->sz;
    test.distance = scaled / test.determinant;  // NaN for a degenerate triangle: never met
    mask8 inside = ((test.u >= 0) & (test.v >= 0) & (test.w >= 0)) |
                   ((test.u <= 0) & (test.v <= 0) & (test.w <= 0));
    mask8 within = (test.distance > 0) & (test.distance <= reach);
    mask8 others = lanes_unlike(vload8(0, leaf->primitive), ray->from);
    test.lanes = lanes_of(inside & within & others);
    return test;
}

// Takes into `hit` the nearest of a block, if nearer. Of two at the same distance the lower
// primitive wins, so that the answer does not depend on the order of the visit.
void nearest_triangle(global const LobeTriangleLeaf* leaf, const Ray* ray, const Shear* s,
                      Hit* hit) {
    TriangleTest test = test_triangles(leaf, ray, s, hit->distance);
    if (!test.lanes) return;
    real u[LOBE_WIDTH], v[LOBE_WIDTH], w[LOBE_WIDTH], distance[LOBE_WIDTH];
    vstore8(test.u, 0, u);
    vstore8(test.v, 0, v);
    vstore8(test.w, 0, w);
    vstore8(test.distance, 0, distance);
    for (lane_set lanes = test.lanes; lanes; lanes = next_lanes(lanes)) {
        uint i = first_lane(lanes);
        uint primitive = leaf->primitive[i];
        if (distance[i] > hit->distance) continue;
        if (distance[i] == hit->distance && primitive > hit->primitive) continue;
        real scale = 1 / (u[i] + v[i] + w[i]);
        hit->distance = distance[i];
        hit->b1 = v[i] * scale;
        hit->b2 = w[i] * scale;
        hit->primitive = primitive;
    }
}

// Whether any triangle of the block other than the ray's target lies before its reach.
int any_triangle(global const LobeTriangleLeaf* leaf, const Ray* ray, const Shear* s) {
    TriangleTest test = test_triangles(leaf, ray, s, ray->reach);
    if (!test.lanes) return 0;
    return (test.lanes & lanes_of(lanes_unlike(vload8(0, leaf->primitive), ray->target))) != 0;
}

#endif
