// SPDX-License-Identifier: Apache-2.0
// Sending a direction towards a light. One file a kind of light stands beside.
#ifndef LOBE_LIGHT_LIGHT_H
#define LOBE_LIGHT_LIGHT_H

#include "light/light_tree.h"
#include "light/sphere_light.h"
#include "light/triangle_light.h"

LightSample point_light_sample(const LobeLight* light, real3 from) {
    LightSample sample = no_light_sample();
    real3 away = (real3)(light->x, light->y, light->z) - from;
    real squared = dot(away, away);
    sample.distance = sqrt(squared);
    sample.towards = away / sample.distance;
    sample.radiance = (real3)(light->r, light->g, light->b) / squared;
    sample.pdf = squared > 0 ? 1 : 0;
    sample.delta = 1;
    return sample;
}

LightSample distant_light_sample(const LobeLight* light) {
    LightSample sample = no_light_sample();
    sample.distance = REAL_HUGE;
    sample.towards = (real3)(light->x, light->y, light->z);
    sample.radiance = (real3)(light->r, light->g, light->b);
    sample.pdf = 1;
    sample.delta = 1;
    return sample;
}

LightSample sample_chosen_light(const Shapes* shapes, const LobeLight* light, real3 from, uint on,
                                real2 u) {
    if (LOBE_HAS_TRIANGLE_LIGHTS && light->kind == LOBE_LIGHT_TRIANGLE)
        return triangle_light_sample(shapes, light, from, u);
    if (LOBE_HAS_SPHERE_LIGHTS && light->kind == LOBE_LIGHT_SPHERE)
        return sphere_light_sample(light, from, on, u);
    if (LOBE_HAS_POINT_LIGHTS && light->kind == LOBE_LIGHT_POINT)
        return point_light_sample(light, from);
    if (LOBE_HAS_DISTANT_LIGHTS && light->kind == LOBE_LIGHT_DISTANT)
        return distant_light_sample(light);
    return no_light_sample();
}

// A direction from the receiver, on the primitive `on`, towards one light; its pdf includes the
// choice of the light.
LightSample sample_light(const Lights* lights, const Shapes* shapes, const Receiver* receiver,
                         uint on, real choice, real2 u) {
    if (lights->count == 0) return no_light_sample();
    real probability;
    uint chosen = choose_light(lights, receiver, choice, &probability);
    if (!(probability > 0)) return no_light_sample();
    LobeLight light = lights->lights[chosen];
    LightSample sample = sample_chosen_light(shapes, &light, receiver->point, on, u);
    sample.pdf *= probability;
    return sample;
}

// Density with which sample_light would have sent the direction of `ray`, which comes from a point
// of this unit normal, to `surface` on `light`.
real light_pdf(const Lights* lights, const Ray* ray, real3 normal, const Surface* surface) {
    LobeLight light = lights->lights[surface->light];
    real pdf = 0;
    if (LOBE_HAS_TRIANGLE_LIGHTS && light.kind == LOBE_LIGHT_TRIANGLE)
        pdf = triangle_light_pdf(&light, ray, surface);
    if (LOBE_HAS_SPHERE_LIGHTS && light.kind == LOBE_LIGHT_SPHERE)
        pdf = sphere_light_pdf(&light, ray->origin, ray->from);
    Receiver receiver = {ray->origin, normal};
    return pdf > 0 ? pdf * light_probability(lights, &receiver, surface->light) : 0;
}

// Radiance that leaves the light at `surface` towards the origin of `ray`.
real3 emitted_radiance(const Lights* lights, const Ray* ray, const Surface* surface) {
    global const LobeLight* light = &lights->lights[surface->light];
    int seen = light->flags & LOBE_LIGHT_TWO_SIDED || dot(ray->direction, surface->geometric) < 0;
    return seen ? (real3)(light->r, light->g, light->b) : (real3)(0);
}

#endif
