// SPDX-License-Identifier: Apache-2.0
// One scattering event: light that is seen, light that is sent for, and where the path goes on.
// The macros of lobe_scene.h choose between ways that converge to the same picture:
// LOBE_SENDS_LIGHT and LOBE_SEES_LIGHT, at least one of which is 1, and LOBE_BALANCE_HEURISTIC.
#ifndef LOBE_PATH_SHADE_H
#define LOBE_PATH_SHADE_H

#include "brdf/dispatch.h"
#include "core/frame3.h"
#include "core/mis.h"
#include "core/rng.h"
#include "geom/bvh8.h"
#include "light/light.h"
#include "path/scene.h"
#include "path/statistics.h"

// The surface as reflection sees it: both normals on the viewer's side.
typedef struct {
    Frame3 frame;
    real3 side;  // geometric normal on the side of wo
    real3 wo;    // in the frame, wo.z > 0
} ShadingPoint;

ShadingPoint shading_point(const Surface* surface, const Ray* ray) {
    ShadingPoint point;
    real3 out = -ray->direction;
    point.side = dot(out, surface->geometric) < 0 ? -surface->geometric : surface->geometric;
    real3 normal = dot(out, surface->shading) < 0 ? -surface->shading : surface->shading;
    point.frame = make_frame3(normal);
    point.wo = to_local(&point.frame, out);
    return point;
}

// A world direction in the shading frame; below the horizon (z < 0) where the geometry hides it,
// so that shading normals let no light through a surface.
real3 local_direction(const ShadingPoint* point, real3 world) {
    real3 turned = to_local(&point->frame, world);
    return dot(world, point->side) > 0 ? turned : (real3)(0, 0, -1);
}

// Light of shapes can be found in two ways: by sending for it, and by seeing it where the path goes
// on. Where both are in use, the weight of a sample of density `pdf` that the other way makes with
// density `other`.
real shared_weight(real pdf, real other) {
    return LOBE_BALANCE_HEURISTIC ? balance_heuristic(pdf, other) : power_heuristic(pdf, other);
}

// A direction to send for light, from the side of this normal. Where light of shapes is only seen,
// that of points alone.
LightSample light_to_send_for(const Scene* scene, const Surface* surface, real3 side, real choice,
                              real2 u) {
    LightSample light = no_light_sample();
    if (LOBE_SENDS_LIGHT | LOBE_HAS_POINT_LIGHTS | LOBE_HAS_DISTANT_LIGHTS) {
        Receiver receiver = {surface->position, side};
        light =
            sample_light(&scene->lights, &scene->shapes, &receiver, surface->primitive, choice, u);
    }
    if (!LOBE_SENDS_LIGHT && !light.delta) light.pdf = 0;
    return light;
}

// Radiance of the surface itself towards the ray, weighed against having sent for it.
// `pdf` is the density with which the ray came here, from a point of this normal; 0 for what only
// it could find.
real3 seen_light(const Scene* scene, const Ray* ray, real3 normal, const Surface* surface,
                 real pdf) {
    if (surface->light == LOBE_NONE) return (real3)(0);
    real3 radiance = emitted_radiance(&scene->lights, ray, surface);
    if (!LOBE_SENDS_LIGHT || pdf == 0 || is_black(radiance)) return radiance;
    real sent = light_pdf(&scene->lights, ray, normal, surface);
    if (!LOBE_SEES_LIGHT) return sent > 0 ? (real3)(0) : radiance;
    return radiance * shared_weight(pdf, sent);
}

// Light of one sample of a light source that the surface reflects to the viewer, unless something
// stands in the way of `shadow`; black if there is none.
real3 sent_light(const Surface* surface, const LightSample* light, const Scattering* scattering,
                 Ray* shadow, PathCounts* counts) {
    if (is_black(scattering->reflected) || is_black(light->radiance)) {
        if (LOBE_SENDS_LIGHT || light->delta) ++counts->light_useless;
        return (real3)(0);
    }
    *shadow = leave_surface(surface, light->towards);
    // The margin is for neighbours of the light in its own plane, whose distance is the same.
    shadow->reach = light->distance * (1 - R(1.52587890625e-5));
    shadow->target = light->primitive;
    int alone = !LOBE_SEES_LIGHT || light->delta;
    real weight = alone ? 1 : shared_weight(light->pdf, scattering->pdf);
    return scattering->reflected * light->radiance * (weight / light->pdf);
}

// Whether the path, whose throughput is not black, goes on; if it does, its throughput pays for
// those that did not. Paths that still carry a quarter of what they began with all go on: to end
// them saves less time than their noise costs. The survival probability is not capped: a cap makes
// the variance infinite in bright closed scenes.
int survives(real3* throughput, real number, uint depth) {
    real q = 4 * largest_component(*throughput);
    if (depth < LOBE_ROULETTE_DEPTH || q >= 1) return 1;
    if (number >= q) return 0;
    *throughput /= q;
    return 1;
}

#endif
