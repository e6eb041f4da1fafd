// SPDX-License-Identifier: Apache-2.0
// The samples of a pixel that a work-item takes side by side: all lanes go on by one event before
// any goes on by the next, so that their numbers and what their first rays meet are had together.
#ifndef LOBE_PATH_BLOCK_H
#define LOBE_PATH_BLOCK_H

#include "path/camera.h"
#include "path/path.h"
#if LOBE_ABREAST == 8
#include "geom/packet.h"
#endif

typedef struct {
    NumberPairs light, brdf, choice;
    real survival[LOBE_ABREAST];
} BlockNumbers;

// The numbers of the event after `depth` others.
BlockNumbers event_numbers(const Sampler* sampler, uint depth) {
    BlockNumbers n;
    n.choice = pairs_of_numbers(sampler, bounce_dimension(depth, DIMENSION_CHOICE));
    n.light = pairs_of_numbers(sampler, bounce_dimension(depth, DIMENSION_LIGHT));
    n.brdf = pairs_of_numbers(sampler, bounce_dimension(depth, DIMENSION_BRDF));
    if (depth >= LOBE_ROULETTE_DEPTH)
        hashed_numbers(sampler, bounce_dimension(depth, DIMENSION_SURVIVAL), n.survival);
    return n;
}

EventNumbers lane_of(const BlockNumbers* n, uint lane) {
    EventNumbers numbers;
    numbers.light = number_pair(&n->light, lane);
    numbers.brdf = number_pair(&n->brdf, lane);
    numbers.choice = number_pair(&n->choice, lane);
    numbers.survival = n->survival[lane];
    return numbers;
}

// What the rays of a set of lanes meet. `alike` says that they probably run together.
void meet(const Geometry* geometry, const Ray* rays, uint set, int alike, Hit* hits) {
#if LOBE_ABREAST == 8
    if (alike && set == LOBE_ALL_LANES) {
        nearest_hits(geometry, rays, hits);
        return;
    }
#endif
    for (; set; set = without_lowest(set)) {
        uint lane = lowest_lane(set);
        hits[lane] = nearest_hit(geometry, &rays[lane]);
    }
}

// Lanes of a set whose shadow rays meet something.
uint shadowed(const Geometry* geometry, const Ray* rays, uint set) {
    uint dark = 0;
    for (; set; set = without_lowest(set)) {
        uint lane = lowest_lane(set);
        if (is_occluded(geometry, &rays[lane])) dark |= 1u << lane;
    }
    return dark;
}

// Traces the samples [first, first + lanes) of a pixel, whose number in the film is `number`.
void trace_paths(const Scene* scene, global const LobeFrame* frame, global const float* filter,
                 uint2 pixel, uint number, uint first, uint lanes, Path* paths,
                 PathCounts* counts) {
    Sampler sampler = make_sampler((uint2)(frame->seed0, frame->seed1), number, first);
    NumberPairs on_film = pairs_of_numbers(&sampler, DIMENSION_FILTER), on_lens;
    if (LOBE_HAS_THIN_LENS) on_lens = pairs_of_numbers(&sampler, DIMENSION_LENS);
    Ray rays[LOBE_ABREAST], shadows[LOBE_ABREAST];
    Hit hits[LOBE_ABREAST];
    for (uint lane = 0; lane < lanes; ++lane) {
        paths[lane] = no_path();
        real2 film =
            film_point(frame, filter, pixel, number_pair(&on_film, lane), &paths[lane].weight);
        real2 lens = LOBE_HAS_THIN_LENS ? number_pair(&on_lens, lane) : (real2)(0);
        rays[lane] = camera_ray(frame, film, lens);
    }
    uint alive = (1u << lanes) - 1;
    for (uint depth = 0; alive; ++depth) {
        meet(&scene->geometry, rays, alive, depth == 0, hits);
        BlockNumbers numbers;
        if (depth < frame->max_depth) numbers = event_numbers(&sampler, depth);
        uint ended = 0, sending = 0;
        for (uint set = alive; set; set = without_lowest(set)) {
            uint lane = lowest_lane(set);
            Path* path = &paths[lane];
            path->sent = (real3)(0);
            int on = 0;
            if (hits[lane].primitive == LOBE_NONE) {
                escape(path, frame, depth, counts);
            } else {
                EventNumbers own = lane_of(&numbers, lane);
                on = scatter_path(scene, path, &rays[lane], &hits[lane], depth, frame->max_depth,
                                  &own, &shadows[lane], counts);
            }
            if (!on) ended |= 1u << lane;
            if (!is_black(path->sent)) sending |= 1u << lane;
        }
        uint dark = shadowed(&scene->geometry, shadows, sending);
        counts->light_occluded += popcount(dark);
        counts->light_reached += popcount(sending & ~dark);
        for (uint set = sending & ~dark; set; set = without_lowest(set)) {
            uint lane = lowest_lane(set);
            paths[lane].radiance += paths[lane].sent;
        }
        alive &= ~ended;
    }
}

#endif
