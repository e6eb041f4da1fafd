// SPDX-License-Identifier: Apache-2.0
// Rays by themselves, as a path sends them: what `lobe bench` times. Only bench_nearest,
// bench_together and bench_any are timed; the others make their rays.
#include "lobe_scene.h"

#include "core/frame3.h"
#include "light/light.h"
#include "path/camera.h"
#include "shared/bench.h"
#if LOBE_ABREAST == 8
#include "geom/packet.h"
#else
#include "geom/bvh8.h"
#endif

Ray load_ray(global const LobeBenchRay* from) {
    Ray ray = make_ray((real3)(from->ox, from->oy, from->oz), (real3)(from->dx, from->dy, from->dz),
                       from->from);
    ray.reach = from->reach;
    ray.target = from->target;
    return ray;
}

void store_ray(const Ray* ray, int exists, global LobeBenchRay* to) {
    LobeBenchRay r;
    r.ox = (float)ray->origin.x;
    r.oy = (float)ray->origin.y;
    r.oz = (float)ray->origin.z;
    r.dx = (float)ray->direction.x;
    r.dy = (float)ray->direction.y;
    r.dz = (float)ray->direction.z;
    r.reach = (float)ray->reach;
    r.from = ray->from;
    r.target = ray->target;
    r.exists = exists;
    r.pad0 = 0;
    r.pad1 = 0;
    *to = r;
}

void store_hit(const Hit* hit, global LobeBenchHit* to) {
    LobeBenchHit h;
    h.distance = (float)hit->distance;
    h.b1 = (float)hit->b1;
    h.b2 = (float)hit->b2;
    h.primitive = hit->primitive;
    *to = h;
}

// The camera ray of sample i % 8 of a pixel, so that the eight of a pixel follow each other.
kernel void bench_camera(global const LobeFrame* frame, global const float* filter, uint count,
                         global LobeBenchRay* rays) {
    uint i = get_global_id(0);
    if (i >= count) return;
    // Pixels all over the film, however few.
    uint pixels = frame->window_width * frame->window_height;
    uint number = (uint)((ulong)(i / 8) * pixels / max(count / 8, 1u)) % pixels;
    uint sample = i % 8, lane = sample % LOBE_ABREAST;
    uint2 pixel = (uint2)(frame->window_x + number % frame->window_width,
                          frame->window_y + number / frame->window_width);
    Sampler sampler = make_sampler((uint2)(0, 0), number, sample - lane);
    NumberPairs film = pairs_of_numbers(&sampler, DIMENSION_FILTER);
    NumberPairs lens = pairs_of_numbers(&sampler, DIMENSION_LENS);
    real weight;
    real2 at = film_point(frame, filter, pixel, number_pair(&film, lane), &weight);
    Ray ray = camera_ray(frame, at, number_pair(&lens, lane));
    store_ray(&ray, 1, &rays[i]);
}

// From what the rays met: one ray to a light, and one of a cosine direction. Numbers of dimension
// `depth`.
kernel void bench_follow(global const LobeTriangle* triangles, global const LobeVertex* vertices,
                         global const LobeSphere* spheres, global const LobeSurface* surfaces,
                         uint triangle_count, global const LobeLight* lights,
                         global const LobeLightNode* light_nodes, uint light_count, uint light_root,
                         uint depth, uint count, global const LobeBenchRay* rays,
                         global const LobeBenchHit* hits, global LobeBenchRay* shadows,
                         global LobeBenchRay* bounces) {
    uint i = get_global_id(0);
    if (i >= count) return;
    Ray ray = load_ray(&rays[i]);
    Ray none = make_ray((real3)(0), (real3)(0, 0, 1), LOBE_NONE);
    store_ray(&none, 0, &shadows[i]);
    store_ray(&none, 0, &bounces[i]);
    if (!rays[i].exists || hits[i].primitive == LOBE_NONE) return;
    Shapes shapes = {triangles, vertices, spheres, surfaces, triangle_count};
    Lights all = {lights, light_nodes, light_count, light_root};
    Hit hit;
    hit.distance = hits[i].distance;
    hit.b1 = hits[i].b1;
    hit.b2 = hits[i].b2;
    hit.primitive = hits[i].primitive;
    Surface surface = surface_at(&shapes, &ray, &hit);
    real3 normal =
        dot(ray.direction, surface.geometric) > 0 ? -surface.geometric : surface.geometric;

    uint lane = i % LOBE_ABREAST;
    Sampler sampler = make_sampler((uint2)(1, 0), i / LOBE_ABREAST, 0);
    NumberPairs choice = pairs_of_numbers(&sampler, bounce_dimension(depth, DIMENSION_CHOICE));
    NumberPairs place = pairs_of_numbers(&sampler, bounce_dimension(depth, DIMENSION_LIGHT));
    NumberPairs way = pairs_of_numbers(&sampler, bounce_dimension(depth, DIMENSION_BRDF));
    Receiver receiver = {surface.position, normal};
    LightSample light = sample_light(&all, &shapes, &receiver, surface.primitive, choice.x[lane],
                                     number_pair(&place, lane));
    if (light.pdf > 0 && dot(light.towards, normal) > 0) {
        Ray shadow = leave_surface(&surface, light.towards);
        shadow.reach = light.distance * (1 - R(1.52587890625e-5));
        shadow.target = light.primitive;
        store_ray(&shadow, 1, &shadows[i]);
    }
    Frame3 frame = make_frame3(normal);
    real3 turned = cosine_hemisphere(number_pair(&way, lane));
    Ray bounce = leave_surface(&surface, to_world(&frame, turned));
    store_ray(&bounce, 1, &bounces[i]);
}

kernel WIDE_WORK_ITEMS void bench_nearest(global const LobeNode* nodes,
                                          global const LobeTriangleLeaf* triangles,
                                          global const LobeSphereLeaf* spheres, uint count,
                                          global const LobeBenchRay* rays,
                                          global LobeBenchHit* hits) {
    uint i = get_global_id(0);
    if (i >= count) return;
    Geometry geometry = {nodes, triangles, spheres};
    Ray ray = load_ray(&rays[i]);
    Hit hit = nearest_hit(&geometry, &ray);
    store_hit(&hit, &hits[i]);
}

// Eight rays a work-item, as a work-item of the renderer sends its camera rays.
kernel WIDE_WORK_ITEMS void bench_together(global const LobeNode* nodes,
                                           global const LobeTriangleLeaf* triangles,
                                           global const LobeSphereLeaf* spheres, uint count,
                                           global const LobeBenchRay* rays,
                                           global LobeBenchHit* hits) {
    uint first = get_global_id(0) * 8;
    if (first >= count) return;
    Geometry geometry = {nodes, triangles, spheres};
    Ray eight[8];
    Hit met[8];
    for (uint i = 0; i < 8; ++i) eight[i] = load_ray(&rays[first + i]);
#if LOBE_ABREAST == 8
    nearest_hits(&geometry, eight, met);
#else
    for (uint i = 0; i < 8; ++i) met[i] = nearest_hit(&geometry, &eight[i]);
#endif
    for (uint i = 0; i < 8; ++i) store_hit(&met[i], &hits[first + i]);
}

// primitive: 0 if something stands in the way, LOBE_NONE if not.
kernel WIDE_WORK_ITEMS void bench_any(global const LobeNode* nodes,
                                      global const LobeTriangleLeaf* triangles,
                                      global const LobeSphereLeaf* spheres, uint count,
                                      global const LobeBenchRay* rays, global LobeBenchHit* hits) {
    uint i = get_global_id(0);
    if (i >= count) return;
    Geometry geometry = {nodes, triangles, spheres};
    Ray ray = load_ray(&rays[i]);
    Hit hit = no_hit();
    hit.primitive = is_occluded(&geometry, &ray) ? 0 : LOBE_NONE;
    store_hit(&hit, &hits[i]);
}
