// SPDX-License-Identifier: Apache-2.0
// Film points and camera rays. lobe_scene.h decides about lens and filter.
#include "lobe_scene.h"

#include "path/camera.h"

// in: two numbers for the film, two for the lens; all of one pixel.
// out: film point (2), weight, origin (3), direction (3)
kernel void camera_rays(global const LobeFrame* frame, global const float* filter, uint x, uint y,
                        global const real* in, global real* out) {
    uint i = get_global_id(0);
    real weight;
    real2 film = film_point(frame, filter, (uint2)(x, y), vload2(2 * i, in), &weight);
    Ray ray = camera_ray(frame, film, vload2(2 * i + 1, in));
    vstore2(film, 0, out + 9 * i);
    out[9 * i + 2] = weight;
    vstore3(ray.origin, 0, out + 9 * i + 3);
    vstore3(ray.direction, 0, out + 9 * i + 6);
}
