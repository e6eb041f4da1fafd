// SPDX-License-Identifier: Apache-2.0
// Sampling the lights of a scene, and asking the hit of each sample for its density.
#include "lobe_scene.h"

#include "geom/bvh8.h"
#include "light/light.h"

// in: point of view (3), its normal (3), number that chooses the light, two for the point on it.
// out: direction (3), distance, red radiance, pdf; then, of the ray sent there, the light's density
// and its red radiance where it meets the sampled primitive (-1 where it meets something else).
kernel void light_round_trip(global const LobeNode* nodes,
                             global const LobeTriangleLeaf* triangle_leaves,
                             global const LobeSphereLeaf* sphere_leaves,
                             global const LobeTriangle* triangles,
                             global const LobeVertex* vertices, global const LobeSphere* spheres,
                             global const LobeSurface* surfaces, uint triangle_count,
                             global const LobeLight* all, global const LobeLightNode* light_nodes,
                             uint light_count, uint root, uint on, global const real* in,
                             global real* out) {
    uint i = get_global_id(0);
    Geometry geometry = {nodes, triangle_leaves, sphere_leaves};
    Shapes shapes = {triangles, vertices, spheres, surfaces, triangle_count};
    Lights lights = {all, light_nodes, light_count, root};
    global const real* row = in + 9 * i;
    Receiver receiver = {vload3(0, row), vload3(0, row + 3)};
    LightSample sample = sample_light(&lights, &shapes, &receiver, on, row[6], vload2(0, row + 7));
    vstore3(sample.towards, 0, out + 8 * i);
    out[8 * i + 3] = sample.distance;
    out[8 * i + 4] = sample.radiance.x;
    out[8 * i + 5] = sample.pdf;
    out[8 * i + 6] = out[8 * i + 7] = -1;
    if (!(sample.pdf > 0) || sample.delta) return;
    Ray ray = make_ray(receiver.point, sample.towards, on);
    Hit hit = nearest_hit(&geometry, &ray);
    if (hit.primitive != sample.primitive) return;
    Surface surface = surface_at(&shapes, &ray, &hit);
    out[8 * i + 6] = light_pdf(&lights, &ray, receiver.normal, &surface);
    out[8 * i + 7] = emitted_radiance(&lights, &ray, &surface).x;
}

// in: point (3), normal (3), number that chooses. Writes the light and the probability of its being
// chosen, -1 if none is, and then what light_probability says of it.
kernel void light_choose(global const LobeLight* all, global const LobeLightNode* nodes,
                         uint light_count, uint root, global const real* in, global uint* chosen,
                         global real* probability) {
    uint i = get_global_id(0);
    Lights lights = {all, nodes, light_count, root};
    Receiver receiver = {vload3(0, in + 7 * i), vload3(0, in + 7 * i + 3)};
    real p;
    chosen[i] = choose_light(&lights, &receiver, in[7 * i + 6], &p);
    probability[2 * i] = p > 0 ? p : -1;
    probability[2 * i + 1] = p > 0 ? light_probability(&lights, &receiver, chosen[i]) : -1;
}

// Probability of every light for one receiver (in: point, normal).
kernel void light_probabilities(global const LobeLight* all, global const LobeLightNode* nodes,
                                uint light_count, uint root, global const real* in,
                                global real* probability) {
    uint i = get_global_id(0);
    Lights lights = {all, nodes, light_count, root};
    Receiver receiver = {vload3(0, in), vload3(0, in + 3)};
    probability[i] = light_probability(&lights, &receiver, i);
}
