// SPDX-License-Identifier: Apache-2.0
// A triangle that emits, sampled uniformly over its area.
#ifndef LOBE_LIGHT_TRIANGLE_LIGHT_H
#define LOBE_LIGHT_TRIANGLE_LIGHT_H

#include "light/light_sample.h"

LightSample triangle_light_sample(const Shapes* shapes, const LobeLight* light, real3 from,
                                  real2 u) {
    LightSample sample = no_light_sample();
    LobeTriangle triangle = shapes->triangles[light->primitive];
    real3 p0 = vertex_position(&shapes->vertices[triangle.v0]);
    real3 e1 = vertex_position(&shapes->vertices[triangle.v1]) - p0;
    real3 e2 = vertex_position(&shapes->vertices[triangle.v2]) - p0;
    real2 b = uniform_triangle(u);
    real3 away = p0 + b.x * e1 + b.y * e2 - from;
    real squared = dot(away, away);
    if (!(squared > 0)) return sample;
    sample.distance = sqrt(squared);
    sample.towards = away / sample.distance;
    real cosine = -dot(sample.towards, normalize(cross(e1, e2)));
    if (light->flags & LOBE_LIGHT_FLIPPED) cosine = -cosine;
    if (light->flags & LOBE_LIGHT_TWO_SIDED) cosine = fabs(cosine);
    if (!(cosine > 0)) return sample;
    sample.radiance = (real3)(light->r, light->g, light->b);
    sample.pdf = squared / (cosine * light->area);
    sample.primitive = light->primitive;
    return sample;
}

// Density per solid angle of the sampler above for a ray that met the light at `surface`.
real triangle_light_pdf(const LobeLight* light, const Ray* ray, const Surface* surface) {
    real3 away = surface->position - ray->origin;
    real cosine = fabs(dot(ray->direction, surface->geometric));
    return cosine > 0 ? dot(away, away) / (cosine * light->area) : 0;
}

#endif
