// SPDX-License-Identifier: Apache-2.0
// One scattering event: light that is seen, light that is sent for, and where the path goes on.
#ifndef LOBE_PATH_SHADE_H
#define LOBE_PATH_SHADE_H

#include "brdf/dispatch.h"
#include "core/frame3.h"
#include "core/mis.h"
#include "core/rng.h"
#include "geom/bvh8.h"
#include "light/light.h"
#include "path/scene.h"

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

// Radiance of the surface itself towards the ray, weighed against having sampled its light.
// `pdf` is the density with which the ray was sent here; 0 for what only it could find.
real3 seen_light(const Scene* scene, const Ray* ray, const Surface* surface, real pdf) {
    if (surface->light == LOBE_NONE) return (real3)(0);
    real3 radiance = emitted_radiance(&scene->lights, ray, surface);
    if (pdf == 0 || is_black(radiance)) return radiance;
    return radiance * power_heuristic(pdf, light_pdf(&scene->lights, ray, surface));
}

// Light of one sample of a light source that the surface reflects to the viewer.
real3 sent_light(const Scene* scene, const Surface* surface, const LightSample* light,
                 const Scattering* scattering) {
    if (is_black(scattering->reflected)) return (real3)(0);
    Ray shadow = leave_surface(surface, light->towards);
    // The margin is for neighbours of the light in its own plane, whose distance is the same.
    shadow.reach = light->distance * (1 - R(1.52587890625e-5));
    shadow.target = light->primitive;
    if (is_occluded(&scene->geometry, &shadow)) return (real3)(0);
    real weight = light->delta ? 1 : power_heuristic(light->pdf, scattering->pdf);
    return scattering->reflected * light->radiance * (weight / light->pdf);
}

// Whether the path goes on; if it does, its throughput pays for those that did not. The survival
// probability is not capped: a cap makes the variance infinite in bright closed scenes.
int survives(real3* throughput, const Sampler* sampler, uint depth) {
    real q = largest_component(*throughput);
    if (!(q > 0)) return 0;
    if (depth < LOBE_ROULETTE_DEPTH || q >= 1) return 1;
    if (hashed_number(sampler, bounce_dimension(depth, DIMENSION_SURVIVAL)) >= q) return 0;
    *throughput /= q;
    return 1;
}

#endif
