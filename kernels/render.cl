// SPDX-License-Identifier: Apache-2.0
// The megakernel: one work-item, one pixel of a tile, one block of samples.
#include "lobe_scene.h"

#include "path/camera.h"
#include "path/film.h"
#include "path/scene.h"
#include "path/shade.h"
#include "path/statistics.h"

// Radiance that arrives along `ray`. `emitter` tells whether a light is seen directly.
real3 trace_path(const Scene* scene, global const LobeFrame* frame, Ray ray, const Sampler* sampler,
                 int* emitter, PathCounts* counts) {
    real3 radiance = (real3)(0), throughput = (real3)(1);
    real pdf = 0;  // of the ray's direction; 0: no light sample could have taken it
    *emitter = 0;
    for (uint depth = 0;; ++depth) {
        Hit hit = nearest_hit(&scene->geometry, &ray);
        if (hit.primitive == LOBE_NONE) {
            if (LOBE_HAS_ENVIRONMENT) {
                radiance += throughput * (real3)(frame->environment_r, frame->environment_g,
                                                 frame->environment_b);
            }
            count_end(counts, LOBE_STATISTIC_ESCAPED, depth);
            return radiance;
        }
        Surface surface = surface_at(&scene->shapes, &ray, &hit);
        radiance += throughput * seen_light(scene, &ray, &surface, pdf);
        if (depth == 0) *emitter = surface.light != LOBE_NONE;
        if (depth == frame->max_depth) {
            count_truncated(counts, throughput, depth);
            return radiance;
        }

        ShadingPoint point = shading_point(&surface, &ray);
        real2 choice = pair_of_numbers(sampler, bounce_dimension(depth, DIMENSION_CHOICE));
        real2 u = pair_of_numbers(sampler, bounce_dimension(depth, DIMENSION_LIGHT));
        LightSample light = light_to_send_for(scene, &surface, choice.x, u);
        real3 wi = light.pdf > 0 ? local_direction(&point, light.towards) : (real3)(0, 0, -1);

        real2 v = pair_of_numbers(sampler, bounce_dimension(depth, DIMENSION_BRDF));
        global const uchar* prepared =
            scene->prepared + (ulong)surface.material * LOBE_PREPARED_BYTES;
        Scattering scattering = scatter(scene->materials[surface.material].model, prepared,
                                        scene->tables, point.wo, wi, (real3)(v, choice.y));
        radiance += throughput * sent_light(scene, &surface, &light, &scattering, counts);

        ++counts->directions;
        real3 direction = to_world(&point.frame, scattering.next.wi);
        throughput *= scattering.next.weight;
        // What is not a number must reach the film's counters before a comparison hides it.
        int sound = isfinite(throughput.x + throughput.y + throughput.z);
        if (!sound || !(largest_component(throughput) > 0) || dot(direction, point.side) <= 0) {
            count_end(counts, LOBE_STATISTIC_LOST, depth);
            return sound ? radiance : throughput;
        }
        if (!survives(&throughput, sampler, depth)) {
            count_end(counts, LOBE_STATISTIC_ROULETTE, depth);
            return radiance;
        }
        pdf = scattering.next.delta ? 0 : scattering.next.pdf;
        ray = leave_surface(&surface, direction);
    }
}

kernel void render(global const LobeFrame* frame, global const LobeNode* nodes,
                   global const LobeTriangleLeaf* triangle_leaves,
                   global const LobeSphereLeaf* sphere_leaves, global const LobeTriangle* triangles,
                   global const LobeVertex* vertices, global const LobeSphere* spheres,
                   global const LobeSurface* surfaces, global const LobeMaterial* materials,
                   global const uchar* prepared, global const LobeLight* lights,
                   global const float* light_sums, global const float* tables,
                   global const float* filter, global const LobeTileJob* jobs,
                   global LobeBlockSum* sums, global uint* status, global uint* statistics) {
    uint slot = get_global_id(1) / LOBE_TILE;
    uint2 place = (uint2)(get_global_id(0), get_global_id(1) % LOBE_TILE);
    if (place.x >= LOBE_TILE || slot >= frame->tiles) return;
    LobeTileJob job = jobs[slot];
    uint2 corner = (uint2)(job.tile % frame->tiles_across, job.tile / frame->tiles_across);
    uint2 window = corner * LOBE_TILE + place;
    if (window.x >= frame->window_width || window.y >= frame->window_height) return;
    Scene scene = {{nodes, triangle_leaves, sphere_leaves},
                   {triangles, vertices, spheres, surfaces, frame->triangles},
                   {lights, light_sums, frame->lights},
                   materials,
                   prepared,
                   tables};
    uint2 pixel = (uint2)(frame->window_x, frame->window_y) + window;
    uint number = pixel.y * frame->film_width + pixel.x;
    LobeBlockSum sum[LOBE_REPLICATES] = {{0, 0, 0, 0}};
    PathCounts counts = no_counts();
    for (uint sample = job.first_sample; sample < job.first_sample + frame->samples; ++sample) {
        Sampler sampler = make_sampler((uint2)(frame->seed0, frame->seed1), number, sample);
        real weight;
        real2 film =
            film_point(frame, filter, pixel, pair_of_numbers(&sampler, DIMENSION_FILTER), &weight);
        real2 lens = LOBE_HAS_THIN_LENS ? pair_of_numbers(&sampler, DIMENSION_LENS) : (real2)(0);
        int emitter;
        real3 radiance =
            trace_path(&scene, frame, camera_ray(frame, film, lens), &sampler, &emitter, &counts);
        add_sample(&sum[sample % LOBE_REPLICATES], radiance, weight, emitter, status, number,
                   sample);
    }
    ulong out = ((ulong)get_global_id(1) * LOBE_TILE + place.x) * LOBE_REPLICATES;
    for (uint i = 0; i < LOBE_REPLICATES; ++i) sums[out + i] = sum[i];
    if (frame->lights == 0) counts.light_useless = 0;  // none was sent for
    add_counts(statistics + (ulong)slot * LOBE_STATISTIC_COUNT, &counts);
}

// Makes every material's prepared form, once before the first launch.
kernel void prepare(global const LobeMaterial* materials, global const LobeRow* rows,
                    global uchar* prepared, uint count, global uint* status) {
    uint i = get_global_id(0);
    if (i >= count) return;
    if (!prepare_material(materials[i].model, rows + materials[i].first_row,
                          prepared + (ulong)i * LOBE_PREPARED_BYTES)) {
        atomic_inc(&status[LOBE_STATUS_TRAP]);
    }
}
