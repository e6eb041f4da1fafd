// SPDX-License-Identifier: Apache-2.0
// Rays through the hierarchy, and the same rays past every leaf block in a row.
#include "lobe_scene.h"

#include "geom/packet.h"
#include "geom/surface.h"

// Eight numbers a ray: origin, direction, reach, spare; two names: from, target.
Ray probe_ray(global const real* rays, global const uint* names, uint i) {
    Ray ray = make_ray(vload3(0, rays + 8 * i), vload3(0, rays + 8 * i + 3), names[2 * i]);
    ray.reach = rays[8 * i + 6];
    ray.target = names[2 * i + 1];
    return ray;
}

void store_hit(const Hit* hit, uint i, global real* out, global uint* primitives) {
    out[3 * i] = hit->distance;
    out[3 * i + 1] = hit->b1;
    out[3 * i + 2] = hit->b2;
    primitives[i] = hit->primitive;
}

// out: distance, b1, b2
kernel void geom_nearest(global const LobeNode* nodes, global const LobeTriangleLeaf* triangles,
                         global const LobeSphereLeaf* spheres, global const real* rays,
                         global const uint* names, global real* out, global uint* primitives) {
    uint i = get_global_id(0);
    Geometry geometry = {nodes, triangles, spheres};
    Ray ray = probe_ray(rays, names, i);
    Hit hit = nearest_hit(&geometry, &ray);
    store_hit(&hit, i, out, primitives);
}

kernel void geom_occluded(global const LobeNode* nodes, global const LobeTriangleLeaf* triangles,
                          global const LobeSphereLeaf* spheres, global const real* rays,
                          global const uint* names, global uint* occluded) {
    uint i = get_global_id(0);
    Geometry geometry = {nodes, triangles, spheres};
    Ray ray = probe_ray(rays, names, i);
    occluded[i] = is_occluded(&geometry, &ray);
}

// The same for eight rays at a time, a work-item's; they start on no primitive and reach
// everywhere.
kernel void geom_nearest_together(global const LobeNode* nodes,
                                  global const LobeTriangleLeaf* triangles,
                                  global const LobeSphereLeaf* spheres, global const real* rays,
                                  global const uint* names, global real* out,
                                  global uint* primitives) {
    uint first = get_global_id(0) * LOBE_WIDTH;
    Geometry geometry = {nodes, triangles, spheres};
    Ray packet[LOBE_WIDTH];
    for (uint i = 0; i < LOBE_WIDTH; ++i) packet[i] = probe_ray(rays, names, first + i);
    Hit hits[LOBE_WIDTH];
    nearest_hits(&geometry, packet, hits);
    for (uint i = 0; i < LOBE_WIDTH; ++i) store_hit(&hits[i], first + i, out, primitives);
}

// The nearest of all leaf blocks, each visited: what the hierarchy must find.
kernel void geom_linear(global const LobeTriangleLeaf* triangles, uint triangle_blocks,
                        global const LobeSphereLeaf* spheres, uint sphere_blocks,
                        global const real* rays, global const uint* names, global real* out,
                        global uint* primitives) {
    uint i = get_global_id(0);
    Ray ray = probe_ray(rays, names, i);
    Shear shear = make_shear(&ray);
    Hit hit = no_hit();
    hit.distance = ray.reach;
    for (uint k = 0; k < triangle_blocks; ++k) nearest_triangle(&triangles[k], &ray, &shear, &hit);
    for (uint k = 0; k < sphere_blocks; ++k) nearest_sphere(&spheres[k], &ray, &hit);
    store_hit(&hit, i, out, primitives);
}

// Rays that met something leave it again: `ways` holds a direction each. out: the eight numbers of
// a ray that starts there, and by how far its start was moved; names: from (LOBE_NONE: no hit).
kernel void geom_leave(global const LobeNode* nodes, global const LobeTriangleLeaf* triangle_leaves,
                       global const LobeSphereLeaf* sphere_leaves,
                       global const LobeTriangle* triangles, global const LobeVertex* vertices,
                       global const LobeSphere* spheres, global const LobeSurface* surfaces,
                       uint triangle_count, global const real* rays, global const uint* names,
                       global const real* ways, global real* out, global uint* from) {
    uint i = get_global_id(0);
    Geometry geometry = {nodes, triangle_leaves, sphere_leaves};
    Shapes shapes = {triangles, vertices, spheres, surfaces, triangle_count};
    Ray ray = probe_ray(rays, names, i);
    Hit hit = nearest_hit(&geometry, &ray);
    from[2 * i] = from[2 * i + 1] = LOBE_NONE;
    for (int k = 0; k < 8; ++k) out[8 * i + k] = 0;
    if (hit.primitive == LOBE_NONE) return;
    Surface surface = surface_at(&shapes, &ray, &hit);
    real3 way = vload3(i, ways);
    Ray next = leave_surface(&surface, way);
    vstore3(next.origin, 0, out + 8 * i);
    vstore3(next.direction, 0, out + 8 * i + 3);
    out[8 * i + 6] = next.reach;
    out[8 * i + 7] = length(next.origin - surface.position);
    from[2 * i] = next.from;
}
