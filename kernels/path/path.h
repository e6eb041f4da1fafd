// SPDX-License-Identifier: Apache-2.0
// One path, from meeting to meeting.
#ifndef LOBE_PATH_PATH_H
#define LOBE_PATH_PATH_H

#include "path/shade.h"

typedef struct {
    real3 radiance, throughput;
    real3 sent;   // what the light sent for adds if nothing stands in its way
    real pdf;     // of the ray's direction; 0: no light sample could have taken it
    real3 side;   // normal of where the ray comes from, on its side
    real weight;  // of the sample in its pixel
    int emitter;  // whether a light is seen directly
} Path;

Path no_path(void) {
    Path path;
    path.radiance = path.sent = (real3)(0);
    path.throughput = (real3)(1);
    path.pdf = 0;
    path.side = (real3)(0);
    path.weight = 1;
    path.emitter = 0;
    return path;
}

// The random numbers of one scattering event.
typedef struct {
    real2 light, brdf, choice;
    real survival;
} EventNumbers;

// Ends a path with what is beyond everything.
void escape(Path* path, global const LobeFrame* frame, uint depth, PathCounts* counts) {
    path->radiance += path->throughput *
                      (real3)(frame->environment_r, frame->environment_g, frame->environment_b);
    count_end(counts, LOBE_STATISTIC_ESCAPED, depth);
}

// Takes a path over what its ray hit, after `depth` scattering events. Returns whether it goes on,
// `ray` then being the next. `shadow` leads to the light of path->sent, if that is not black.
int scatter_path(const Scene* scene, Path* path, Ray* ray, const Hit* hit, uint depth,
                 uint max_depth, const EventNumbers* numbers, Ray* shadow, PathCounts* counts) {
    Surface surface = surface_at(&scene->shapes, ray, hit);
    path->radiance += path->throughput * seen_light(scene, ray, path->side, &surface, path->pdf);
    if (depth == 0) path->emitter = surface.light != LOBE_NONE;
    if (depth == max_depth) {
        count_truncated(counts, path->throughput, depth);
        return 0;
    }

    ShadingPoint point = shading_point(&surface, ray);
    LightSample light =
        light_to_send_for(scene, &surface, point.side, numbers->choice.x, numbers->light);
    real3 wi = light.pdf > 0 ? local_direction(&point, light.towards) : (real3)(0, 0, -1);
    global const uchar* prepared = scene->prepared + (ulong)surface.material * LOBE_PREPARED_BYTES;
    Scattering scattering =
        scatter(scene->materials[surface.material].model, prepared, scene->tables, point.wo, wi,
                (real3)(numbers->brdf, numbers->choice.y));
    path->sent = path->throughput * sent_light(&surface, &light, &scattering, shadow, counts);

    ++counts->directions;
    real3 direction = to_world(&point.frame, scattering.next.wi);
    path->throughput *= scattering.next.weight;
    // What is not a number must reach the film's counters before a comparison hides it.
    if (!isfinite(path->throughput.x + path->throughput.y + path->throughput.z)) {
        count_end(counts, LOBE_STATISTIC_LOST, depth);
        path->radiance = path->throughput;
        return 0;
    }
    if (!(largest_component(path->throughput) > 0) || dot(direction, point.side) <= 0) {
        count_end(counts, LOBE_STATISTIC_LOST, depth);
        return 0;
    }
    if (!survives(&path->throughput, numbers->survival, depth)) {
        count_end(counts, LOBE_STATISTIC_ROULETTE, depth);
        return 0;
    }
    path->pdf = scattering.next.delta ? 0 : scattering.next.pdf;
    if (LOBE_HAS_MANY_LIGHTS) path->side = point.side;
    *ray = leave_surface(&surface, direction);
    return 1;
}

#endif
