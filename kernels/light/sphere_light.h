// SPDX-License-Identifier: Apache-2.0
// A sphere that emits, sampled uniformly over the cone in which it is seen. All is formed from
// 1 - cos of the cone's half angle = sin^2 / (1 + cos), which keeps its precision however small
// the sphere looks (a 1e-4 rad cone is 0 in float as 1 - cos).
#ifndef LOBE_LIGHT_SPHERE_LIGHT_H
#define LOBE_LIGHT_SPHERE_LIGHT_H

#include "core/frame3.h"
#include "light/light_sample.h"

// 1 - cos of the half angle of a sphere of radius r seen from squared distance d2 > r^2.
real seen_cone(real r, real d2) {
    real sine_squared = r * r / d2;
    return sine_squared / (1 + sqrt(larger(0, 1 - sine_squared)));
}

int emits_inwards(const LobeLight* light) {
    return (light->flags & (LOBE_LIGHT_FLIPPED | LOBE_LIGHT_TWO_SIDED)) != 0;
}

int emits_outwards(const LobeLight* light) {
    return !(light->flags & LOBE_LIGHT_FLIPPED) || light->flags & LOBE_LIGHT_TWO_SIDED;
}

// Whether the sphere is seen from inside. A point `on` the sphere itself counts as inside, however
// rounding has placed it: the directions that lead back to the sphere are those that go in.
int sees_inside(const LobeLight* light, real d2, uint on) {
    return on == light->primitive || d2 <= light->radius * light->radius;
}

// From inside, every direction meets the sphere: all are sampled alike.
LightSample inside_sphere_sample(const LobeLight* light, real3 to_centre, uint on, real2 u) {
    LightSample sample = no_light_sample();
    real3 d = uniform_sphere(u);
    real along = dot(to_centre, d);
    if (on == light->primitive && !(along > 0)) return sample;  // it leads away
    real3 across = to_centre - along * d;
    real half_chord = sqrt(larger(0, light->radius * light->radius - dot(across, across)));
    sample.towards = d;
    sample.distance = along + half_chord;
    sample.radiance = (real3)(light->r, light->g, light->b);
    sample.pdf = R(0.5) * REAL_INV_TWO_PI;
    sample.primitive = light->primitive;
    return sample;
}

// From the point `from` of the primitive `on`.
LightSample sphere_light_sample(const LobeLight* light, real3 from, uint on, real2 u) {
    real3 to_centre = (real3)(light->x, light->y, light->z) - from;
    real d2 = dot(to_centre, to_centre);
    real r2 = light->radius * light->radius;
    LightSample sample = no_light_sample();
    if (sees_inside(light, d2, on)) {
        return emits_inwards(light) ? inside_sphere_sample(light, to_centre, on, u) : sample;
    }
    if (!emits_outwards(light)) return sample;
    real cone = seen_cone(light->radius, d2);
    real d = sqrt(d2);
    real3 in_cone = uniform_cone(u, cone);
    Frame3 frame = make_frame3(to_centre / d);
    sample.towards = to_world(&frame, in_cone);
    // Sine of the direction's angle to the axis, from the vector itself: exact for tiny cones.
    real sine_squared = in_cone.x * in_cone.x + in_cone.y * in_cone.y;
    sample.distance = d * in_cone.z - sqrt(larger(0, r2 - d2 * sine_squared));
    sample.radiance = (real3)(light->r, light->g, light->b);
    sample.pdf = REAL_INV_TWO_PI / cone;
    sample.primitive = light->primitive;
    return sample;
}

// Density per solid angle of the sampler above, for any direction that meets the sphere.
real sphere_light_pdf(const LobeLight* light, real3 from, uint on) {
    real3 to_centre = (real3)(light->x, light->y, light->z) - from;
    real d2 = dot(to_centre, to_centre);
    if (sees_inside(light, d2, on)) return R(0.5) * REAL_INV_TWO_PI;
    return REAL_INV_TWO_PI / seen_cone(light->radius, d2);
}

#endif
