// SPDX-License-Identifier: Apache-2.0
// Travelling through the eight-wide hierarchy: one ray against eight boxes at a time.
//
// Boxes are enlarged once when built, by more than the rounding of the two operations per plane
// can lose, so the test here is one fma a plane and still conservative. Every wait on the stack
// keeps its entry distance in the upper word: what lies behind the nearest hit is dropped unseen.
#ifndef LOBE_GEOM_BVH8_H
#define LOBE_GEOM_BVH8_H

#include "geom/sphere.h"
#include "geom/triangle.h"

#define LOBE_STACK_SIZE 128  // the builder makes no tree that could need more

// The ray as boxes see it: t = plane * inverse + shift, near planes by the signs of the direction.
typedef struct {
    real3 inverse, shift;
    int near_x, near_y, near_z;  // rows of LobeNode::plane; the far row is the other of the pair
} Slabs;

// A direction parallel to a plane gets a huge but finite inverse, which keeps NaN out of the test.
real safe_inverse(real d) { return 1 / (fabs(d) > R(1e-18) ? d : copysign(R(1e-18), d)); }

Slabs make_slabs(const Ray* ray) {
    Slabs s;
    s.inverse = (real3)(safe_inverse(ray->direction.x), safe_inverse(ray->direction.y),
                        safe_inverse(ray->direction.z));
    s.shift = -ray->origin * s.inverse;
    s.near_x = s.inverse.x < 0 ? 1 : 0;
    s.near_y = s.inverse.y < 0 ? 3 : 2;
    s.near_z = s.inverse.z < 0 ? 5 : 4;
    return s;
}

real8 to_plane(global const LobeNode* node, int row, real inverse, real shift) {
    return fma(load_lanes(node->plane[row]), (real8)(inverse), (real8)(shift));
}

// Children entered before `reach`, and where.
lane_set enter_children(global const LobeNode* node, const Slabs* s, real reach, real8* entry) {
    real8 near_x = to_plane(node, s->near_x, s->inverse.x, s->shift.x);
    real8 near_y = to_plane(node, s->near_y, s->inverse.y, s->shift.y);
    real8 near_z = to_plane(node, s->near_z, s->inverse.z, s->shift.z);
    real8 far_x = to_plane(node, s->near_x ^ 1, s->inverse.x, s->shift.x);
    real8 far_y = to_plane(node, s->near_y ^ 1, s->inverse.y, s->shift.y);
    real8 far_z = to_plane(node, s->near_z ^ 1, s->inverse.z, s->shift.z);
    *entry = larger8(larger8(near_x, near_y), larger8(near_z, (real8)(0)));
    real8 exit = smaller8(smaller8(far_x, far_y), smaller8(far_z, (real8)(reach)));
    return lanes_of(*entry <= exit);
}

// A wait on the stack: entry distance above, child below. Distances are never negative, so the
// words compare as the distances do. (In double the distance is rounded towards zero: earlier.)
#if LOBE_DOUBLE
ulong make_wait(real entry, uint child) {
    return ((ulong)as_uint(convert_float_rtz(entry)) << 32) | child;
}
#else
ulong make_wait(real entry, uint child) { return ((ulong)as_uint(entry) << 32) | child; }
#endif
real wait_entry(ulong wait) { return (real)as_float((uint)(wait >> 32)); }

// Asks memory for a node or the first block of a leaf that is to be visited, all its lines.
void fetch_child(const Geometry* g, uint child) {
    if (!LOBE_HAS_FETCH_AHEAD) return;
    ulong at = (ulong)(g->nodes + child);
    ulong size = sizeof(LobeNode);
    if (child & LOBE_LEAF) {
        at = (ulong)(g->triangle_leaves + (child & LOBE_LEAF_INDEX));
        size = sizeof(LobeTriangleLeaf);
    }
    for (ulong line = 0; line < size; line += 64) fetch_line(at + line);
}

// Puts the children in `lanes` on the stack, nearest on top. Returns the new height.
uint push_nearest_last(const Geometry* g, ulong* stack, uint height, lane_set lanes, real8 entries,
                       global const LobeNode* node) {
    real entry[LOBE_WIDTH];
    vstore8(entries, 0, entry);
    uint base = height;
    for (; lanes; lanes = next_lanes(lanes)) {
        uint i = first_lane(lanes);
        fetch_child(g, node->child[i]);
        ulong wait = make_wait(entry[i], node->child[i]);
        uint at = height++;
        for (; at > base && stack[at - 1] < wait; --at) stack[at] = stack[at - 1];
        stack[at] = wait;
    }
    return height;
}

// Which kind of shape a leaf holds; known at compile time where the scene has but one kind.
int holds_spheres(uint child) {
    if (!LOBE_HAS_SPHERES) return 0;
    if (!LOBE_HAS_TRIANGLES) return 1;
    return (child & LOBE_LEAF_SPHERES) != 0;
}

void nearest_in_leaf(const Geometry* g, uint child, const Ray* ray, const Shear* shear, Hit* hit) {
    uint first = child & LOBE_LEAF_INDEX;
    uint count = ((child >> LOBE_LEAF_SHIFT) & (LOBE_LEAF_BLOCKS - 1)) + 1;
    for (uint i = first; i < first + count; ++i) {
        if (holds_spheres(child)) {
            nearest_sphere(&g->sphere_leaves[i], ray, hit);
        } else {
            nearest_triangle(&g->triangle_leaves[i], ray, shear, hit);
        }
    }
}

int any_in_leaf(const Geometry* g, uint child, const Ray* ray, const Shear* shear) {
    uint first = child & LOBE_LEAF_INDEX;
    uint count = ((child >> LOBE_LEAF_SHIFT) & (LOBE_LEAF_BLOCKS - 1)) + 1;
    for (uint i = first; i < first + count; ++i) {
        if (holds_spheres(child)) {
            if (any_sphere(&g->sphere_leaves[i], ray)) return 1;
        } else {
            if (any_triangle(&g->triangle_leaves[i], ray, shear)) return 1;
        }
    }
    return 0;
}

// The nearest thing the ray meets within its reach. Node 0 is the root; there is always one.
Hit nearest_hit(const Geometry* g, const Ray* ray) {
    Slabs slabs = make_slabs(ray);
    Shear shear = make_shear(ray);
    Hit hit = no_hit();
    hit.distance = ray->reach;
    ulong stack[LOBE_STACK_SIZE];
    uint height = 0;
    uint current = 0;
    for (;;) {
        if (current & LOBE_LEAF) {
            nearest_in_leaf(g, current, ray, &shear, &hit);
        } else {
            global const LobeNode* node = &g->nodes[current];
            real8 entries;
            lane_set lanes = enter_children(node, &slabs, hit.distance, &entries);
            if (lanes && !next_lanes(lanes)) {
                current = node->child[first_lane(lanes)];
                continue;
            }
            height = push_nearest_last(g, stack, height, lanes, entries, node);
        }
        ulong wait;
        do {
            if (height == 0) return hit;
            wait = stack[--height];
        } while (wait_entry(wait) > hit.distance);
        current = (uint)wait;
    }
}

// Whether anything but its target stands in the ray's way.
int is_occluded(const Geometry* g, const Ray* ray) {
    Slabs slabs = make_slabs(ray);
    Shear shear = make_shear(ray);
    uint stack[LOBE_STACK_SIZE];
    uint height = 0;
    uint current = 0;
    for (;;) {
        if (current & LOBE_LEAF) {
            if (any_in_leaf(g, current, ray, &shear)) return 1;
        } else {
            global const LobeNode* node = &g->nodes[current];
            real8 entries;
            lane_set lanes = enter_children(node, &slabs, ray->reach, &entries);
            for (; lanes; lanes = next_lanes(lanes)) {
                stack[height] = node->child[first_lane(lanes)];
                fetch_child(g, stack[height++]);
            }
        }
        if (height == 0) return 0;
        current = stack[--height];
    }
}

#endif
