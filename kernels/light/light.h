// SPDX-License-Identifier: Apache-2.0
// Choosing a light and sending a direction towards it. One file a kind of light stands beside.
#ifndef LOBE_LIGHT_LIGHT_H
#define LOBE_LIGHT_LIGHT_H

#include "light/sphere_light.h"
#include "light/triangle_light.h"

typedef struct {
    global const LobeLight* lights;
    global const float* sums;  // running sum of the lights' probabilities; the last is 1
    uint count;
} Lights;

// The light whose part of [0, 1) holds u.
uint choose_light(const Lights* lights, real u) {
    uint first = 0, last = lights->count - 1;
    while (first < last) {
        uint middle = (first + last) / 2;
        if (u < lights->sums[middle]) {
            last = middle;
        } else {
            first = middle + 1;
        }
    }
    return first;
}

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

// A direction from the point `from` of the primitive `on` towards one light; its pdf includes the
// choice of the light.
LightSample sample_light(const Lights* lights, const Shapes* shapes, real3 from, uint on,
                         real choice, real2 u) {
    if (lights->count == 0) return no_light_sample();
    LobeLight light = lights->lights[choose_light(lights, choice)];
    LightSample sample = sample_chosen_light(shapes, &light, from, on, u);
    sample.pdf *= light.probability;
    return sample;
}

// Density with which sample_light would have sent the direction of `ray` to `surface` on `light`.
real light_pdf(const Lights* lights, const Ray* ray, const Surface* surface) {
    LobeLight light = lights->lights[surface->light];
    real pdf = 0;
    if (LOBE_HAS_TRIANGLE_LIGHTS && light.kind == LOBE_LIGHT_TRIANGLE)
        pdf = triangle_light_pdf(&light, ray, surface);
    if (LOBE_HAS_SPHERE_LIGHTS && light.kind == LOBE_LIGHT_SPHERE)
        pdf = sphere_light_pdf(&light, ray->origin, ray->from);
    return pdf * light.probability;
}

// Radiance that leaves the light at `surface` towards the origin of `ray`.
real3 emitted_radiance(const Lights* lights, const Ray* ray, const Surface* surface) {
    global const LobeLight* light = &lights->lights[surface->light];
    int seen = light->flags & LOBE_LIGHT_TWO_SIDED || dot(ray->direction, surface->geometric) < 0;
    return seen ? (real3)(light->r, light->g, light->b) : (real3)(0);
}

#endif
