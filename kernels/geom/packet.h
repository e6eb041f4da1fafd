// SPDX-License-Identifier: Apache-2.0
// Eight rays that run alike through the hierarchy together: a node is read once for all of them,
// and a triangle meets all eight at a time. What they meet has the same bits as with single rays.
// That pays for camera rays. Shadow rays would need a box test for each ray: by bounds alone eight
// of neighbouring pixels ran at 0.1 to 0.6 of the speed of single ones.
#ifndef LOBE_GEOM_PACKET_H
#define LOBE_GEOM_PACKET_H

#include "geom/bvh8.h"

// Rays whose directions have the same signs and run fastest along the same axis.
typedef struct {
    const Ray* rays;
    int near_x, near_y, near_z;  // as in Slabs, for all
    int kx, ky, kz;              // as in Shear, for all
    real8 ox, oy, oz, sx, sy, sz;
    real3 low_origin, high_origin, low_inverse, high_inverse;  // bounds of all
} Packet;

// Returns 0 if the rays do not run alike.
int make_packet(const Ray* rays, Packet* p) {
    real o[3][LOBE_WIDTH], s[3][LOBE_WIDTH];
    for (uint i = 0; i < LOBE_WIDTH; ++i) {
        Slabs slabs = make_slabs(&rays[i]);
        Shear shear = make_shear(&rays[i]);
        if (i == 0) {
            p->rays = rays;
            p->near_x = slabs.near_x;
            p->near_y = slabs.near_y;
            p->near_z = slabs.near_z;
            p->kx = shear.kx;
            p->ky = shear.ky;
            p->kz = shear.kz;
            p->low_origin = p->high_origin = rays[i].origin;
            p->low_inverse = p->high_inverse = slabs.inverse;
        }
        if (slabs.near_x != p->near_x || slabs.near_y != p->near_y || slabs.near_z != p->near_z ||
            shear.kz != p->kz)
            return 0;
        p->low_origin = min(p->low_origin, rays[i].origin);
        p->high_origin = max(p->high_origin, rays[i].origin);
        p->low_inverse = min(p->low_inverse, slabs.inverse);
        p->high_inverse = max(p->high_inverse, slabs.inverse);
        o[0][i] = shear.ox;
        o[1][i] = shear.oy;
        o[2][i] = shear.oz;
        s[0][i] = shear.sx;
        s[1][i] = shear.sy;
        s[2][i] = shear.sz;
    }
    p->ox = vload8(0, o[0]);
    p->oy = vload8(0, o[1]);
    p->oz = vload8(0, o[2]);
    p->sx = vload8(0, s[0]);
    p->sy = vload8(0, s[1]);
    p->sz = vload8(0, s[2]);
    return 1;
}

// Bounds of the distances at which the rays of a packet cross eight planes, by interval arithmetic.
// Its three roundings lose less than what boxes were enlarged by.
real8 soonest(real8 planes, real low_origin, real high_origin, real low, real high) {
    real8 far = planes - low_origin, near = planes - high_origin;
    return smaller8(smaller8(far * low, far * high), smaller8(near * low, near * high));
}
real8 latest(real8 planes, real low_origin, real high_origin, real low, real high) {
    real8 far = planes - low_origin, near = planes - high_origin;
    return larger8(larger8(far * low, far * high), larger8(near * low, near * high));
}

// Children that some ray of the packet may enter before `reach`, and where.
lane_set enter_children_together(global const LobeNode* node, const Packet* p, real reach,
                                 real8* entry) {
    real3 o = p->low_origin, q = p->high_origin, l = p->low_inverse, h = p->high_inverse;
    real8 near_x = soonest(load_lanes(node->plane[p->near_x]), o.x, q.x, l.x, h.x);
    real8 near_y = soonest(load_lanes(node->plane[p->near_y]), o.y, q.y, l.y, h.y);
    real8 near_z = soonest(load_lanes(node->plane[p->near_z]), o.z, q.z, l.z, h.z);
    real8 far_x = latest(load_lanes(node->plane[p->near_x ^ 1]), o.x, q.x, l.x, h.x);
    real8 far_y = latest(load_lanes(node->plane[p->near_y ^ 1]), o.y, q.y, l.y, h.y);
    real8 far_z = latest(load_lanes(node->plane[p->near_z ^ 1]), o.z, q.z, l.z, h.z);
    *entry = larger8(larger8(near_x, near_y), larger8(near_z, (real8)(0)));
    real8 exit = smaller8(smaller8(far_x, far_y), smaller8(far_z, (real8)(reach)));
    return lanes_of(*entry <= exit);
}

// One triangle of a block against the rays, one a lane, by the operations of test_triangles.
typedef struct {
    real8 v, w, determinant, distance;
    mask8 inside;
} PacketTest;

// Returns 0, and no more, if no ray passes inside.
int test_packet(global const LobeTriangleLeaf* leaf, uint i, const Packet* p, PacketTest* test) {
    real8 az = (real8)(leaf->vertex[0][p->kz][i]) - p->oz;
    real8 bz = (real8)(leaf->vertex[1][p->kz][i]) - p->oz;
    real8 cz = (real8)(leaf->vertex[2][p->kz][i]) - p->oz;
    real8 ax = fma(-p->sx, az, (real8)(leaf->vertex[0][p->kx][i]) - p->ox);
    real8 ay = fma(-p->sy, az, (real8)(leaf->vertex[0][p->ky][i]) - p->oy);
    real8 bx = fma(-p->sx, bz, (real8)(leaf->vertex[1][p->kx][i]) - p->ox);
    real8 by = fma(-p->sy, bz, (real8)(leaf->vertex[1][p->ky][i]) - p->oy);
    real8 cx = fma(-p->sx, cz, (real8)(leaf->vertex[2][p->kx][i]) - p->ox);
    real8 cy = fma(-p->sy, cz, (real8)(leaf->vertex[2][p->ky][i]) - p->oy);
    real8 u = cx * by - cy * bx;
    test->v = ax * cy - ay * cx;
    test->w = bx * ay - by * ax;
    test->inside =
        ((u >= 0) & (test->v >= 0) & (test->w >= 0)) | ((u <= 0) & (test->v <= 0) & (test->w <= 0));
    if (!lanes_of(test->inside)) return 0;
    test->determinant = u + test->v + test->w;
    real8 scaled = fma(u, az, fma(test->v, bz, test->w * cz)) * p->sz;
    test->distance = scaled / test->determinant;
    return 1;
}

typedef struct {
    real8 distance, b1, b2;
    uint8 primitive;
} Hits;

void nearest_triangle_together(global const LobeTriangleLeaf* leaf, uint i, const Packet* p,
                               Hits* hits) {
    PacketTest test;
    if (!test_packet(leaf, i, p, &test)) return;
    uint primitive = leaf->primitive[i];
    mask8 tie = (test.distance == hits->distance) & lanes_above(hits->primitive, primitive);
    mask8 met = test.inside & (test.distance > 0) & ((test.distance < hits->distance) | tie);
    if (!lanes_of(met)) return;
    real8 scale = 1 / test.determinant;
    hits->distance = met ? test.distance : hits->distance;
    hits->b1 = met ? test.v * scale : hits->b1;
    hits->b2 = met ? test.w * scale : hits->b2;
    hits->primitive = narrow_mask(met) ? (uint8)(primitive) : hits->primitive;
}

void nearest_spheres_together(global const LobeSphereLeaf* leaf, const Packet* p, Hits* hits) {
    real distance[LOBE_WIDTH];
    uint primitive[LOBE_WIDTH];
    vstore8(hits->distance, 0, distance);
    vstore8(hits->primitive, 0, primitive);
    for (uint i = 0; i < LOBE_WIDTH; ++i) {
        Hit hit = no_hit();
        hit.distance = distance[i];
        hit.primitive = primitive[i];
        nearest_sphere(leaf, &p->rays[i], &hit);
        distance[i] = hit.distance;
        primitive[i] = hit.primitive;
    }
    hits->distance = vload8(0, distance);
    hits->primitive = vload8(0, primitive);
}

void nearest_in_leaf_together(const Geometry* g, uint child, const Packet* p, Hits* hits) {
    uint first = child & LOBE_LEAF_INDEX;
    uint count = ((child >> LOBE_LEAF_SHIFT) & (LOBE_LEAF_BLOCKS - 1)) + 1;
    for (uint k = first; k < first + count; ++k) {
        if (holds_spheres(child)) {
            nearest_spheres_together(&g->sphere_leaves[k], p, hits);
            continue;
        }
        global const LobeTriangleLeaf* leaf = &g->triangle_leaves[k];
        for (uint i = 0; i < LOBE_WIDTH && leaf->primitive[i] != LOBE_NONE; ++i)
            nearest_triangle_together(leaf, i, p, hits);
    }
}

void store_hits(const Hits* hits, Hit* to) {
    real distance[LOBE_WIDTH], b1[LOBE_WIDTH], b2[LOBE_WIDTH];
    uint primitive[LOBE_WIDTH];
    vstore8(hits->distance, 0, distance);
    vstore8(hits->b1, 0, b1);
    vstore8(hits->b2, 0, b2);
    vstore8(hits->primitive, 0, primitive);
    for (uint i = 0; i < LOBE_WIDTH; ++i) {
        to[i].distance = distance[i];
        to[i].b1 = b1[i];
        to[i].b2 = b2[i];
        to[i].primitive = primitive[i];
    }
}

// nearest_hit for eight rays that start on no primitive and reach everywhere.
void nearest_hits(const Geometry* g, const Ray* rays, Hit* hits) {
    Packet packet;
    if (!make_packet(rays, &packet)) {
        for (uint i = 0; i < LOBE_WIDTH; ++i) hits[i] = nearest_hit(g, &rays[i]);
        return;
    }
    Hits nearest;
    nearest.distance = (real8)(REAL_HUGE);
    nearest.b1 = nearest.b2 = (real8)(0);
    nearest.primitive = (uint8)(LOBE_NONE);
    real reach = REAL_HUGE;  // the farthest of the nearest
    ulong stack[LOBE_STACK_SIZE];
    uint height = 0;
    uint current = 0;
    for (;;) {
        if (current & LOBE_LEAF) {
            nearest_in_leaf_together(g, current, &packet, &nearest);
            reach = largest_lane(nearest.distance);
        } else {
            global const LobeNode* node = &g->nodes[current];
            real8 entries;
            lane_set lanes = enter_children_together(node, &packet, reach, &entries);
            if (lanes && !next_lanes(lanes)) {
                current = node->child[first_lane(lanes)];
                continue;
            }
            height = push_nearest_last(g, stack, height, lanes, entries, node);
        }
        ulong wait;
        do {
            if (height == 0) {
                store_hits(&nearest, hits);
                return;
            }
            wait = stack[--height];
        } while (wait_entry(wait) > reach);
        current = (uint)wait;
    }
}

#endif
