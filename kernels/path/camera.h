// SPDX-License-Identifier: Apache-2.0
// From a sample of a pixel to a ray: pixel filter by importance sampling, perspective, thin lens.
#ifndef LOBE_PATH_CAMERA_H
#define LOBE_PATH_CAMERA_H

#include "core/rng.h"
#include "core/warp.h"
#include "geom/ray.h"

// Offset from the pixel's centre along one axis, in pixels, of a number `side` in [-1, 1): so much
// of the filter's size lies within it. Tabulated over sqrt(1 - |side|), which is dense where
// filters fade out.
real filter_offset(global const float* table, real radius, real side) {
    real at = sqrt(1 - fabs(side)) * (LOBE_FILTER_NODES - 1);
    int node = min((int)at, LOBE_FILTER_NODES - 2);
    real fraction = at - node;
    real offset = table[node] + fraction * ((real)table[node + 1] - table[node]);
    return copysign(radius * offset, side);
}

// Where in the film a sample looks, and its weight: 1, or less than 0 in a filter's negative lobes.
real2 film_point(global const LobeFrame* frame, global const float* filter, uint2 pixel, real2 u,
                 real* weight) {
    real2 centre = (real2)(pixel.x + R(0.5), pixel.y + R(0.5));
    real2 side = 2 * u - 1;
    *weight = 1;
    if (!frame->filter_table) {
        return centre + side * (real2)(frame->filter_radius_x, frame->filter_radius_y);
    }
    real x = filter_offset(filter, frame->filter_radius_x, side.x);
    real y = filter_offset(filter + LOBE_FILTER_NODES, frame->filter_radius_y, side.y);
    // The sign goes by the number, not by the place: so the weights add up to the filter's
    // integral.
    *weight = frame->filter_weight;
    if (fabs(side.x) > frame->filter_negative_x) *weight = -*weight;
    if (fabs(side.y) > frame->filter_negative_y) *weight = -*weight;
    return centre + (real2)(x, y);
}

Ray camera_ray(global const LobeFrame* frame, real2 film, real2 lens) {
    real3 corner = (real3)(frame->corner_x, frame->corner_y, frame->corner_z);
    real3 dx = (real3)(frame->dx_x, frame->dx_y, frame->dx_z);
    real3 dy = (real3)(frame->dy_x, frame->dy_y, frame->dy_z);
    real3 eye = (real3)(frame->eye_x, frame->eye_y, frame->eye_z);
    real3 direction = normalize(corner + film.x * dx + film.y * dy);
    if (LOBE_HAS_THIN_LENS && frame->lens_radius > 0) {
        real3 axis = (real3)(frame->axis_x, frame->axis_y, frame->axis_z);
        real3 focus = direction * (frame->focal_distance / dot(direction, axis));
        real2 at = frame->lens_radius * uniform_disk(lens);
        real3 shift = at.x * normalize(dx) + at.y * normalize(dy);
        eye += shift;
        direction = normalize(focus - shift);
    }
    return make_ray(eye, direction, LOBE_NONE);
}

#endif
