// SPDX-License-Identifier: Apache-2.0
// Sampling the lights of a scene, and asking the hit of each sample for its density.
#include "lobe_scene.h"

#include "geom/bvh8.h"
#include "light/light.h"

// in: point of view (3), number that chooses the light, two numbers for the point on it.
// out: direction (3), distance, red radiance, pdf; then, of the ray sent there, the light's density
// and its red radiance where it meets the sampled primitive (-1 where it meets something else).
kernel void light_round_trip(global const LobeNode* nodes,
                             global const LobeTriangleLeaf* triangle_leaves,
                             global const LobeSphereLeaf* sphere_leaves,
                             global const LobeTriangle* triangles,
                             global const LobeVertex* vertices, global const LobeSphere* spheres,
                             global const LobeSurface* surfaces, uint triangle_count,
                             global const LobeLight* all, global const float* sums,
                             uint light_count, uint on, global const real* in, global real* out) {
    uint i = get_global_id(0);
    Geometry geometry = {nodes, triangle_leaves, sphere_leaves};
    Shapes shapes = {triangles, vertices, spheres, surfaces, triangle_count};
    Lights lights = {all, sums, light_count};
    real3 from = vload3(0, in + 6 * i);
    LightSample sample =
        sample_light(&lights, &shapes, from, on, in[6 * i + 3], vload2(0, in + 6 * i + 4));
    vstore3(sample.towards, 0, out + 8 * i);
    out[8 * i + 3] = sample.distance;
    out[8 * i + 4] = sample.radiance.x;
    out[8 * i + 5] = sample.pdf;
    out[8 * i + 6] = out[8 * i + 7] = -1;
    if (!(sample.pdf > 0) || sample.delta) return;
    Ray ray = make_ray(from, sample.towards, on);
    Hit hit = nearest_hit(&geometry, &ray);
    if (hit.primitive != sample.primitive) return;
    Surface surface = surface_at(&shapes, &ray, &hit);
    out[8 * i + 6] = light_pdf(&lights, &ray, &surface);
    out[8 * i + 7] = emitted_radiance(&lights, &ray, &surface).x;
}

kernel void light_choose(global const float* sums, uint light_count, global const real* u,
                         global uint* chosen) {
    Lights lights = {0, sums, light_count};
    chosen[get_global_id(0)] = choose_light(&lights, u[get_global_id(0)]);
}
