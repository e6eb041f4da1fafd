// SPDX-License-Identifier: Apache-2.0
// Geometry of lobes about the mirror direction: Phong's, the modified one and the rational one.
//
// A direction is known by t = cos phi and x = 1 - t, phi its angle to the mirror direction. Sharp
// lobes live where x ~ 1/n, far below the rounding of t; so x is formed from the difference of the
// vectors, or comes from the sampler, and never from t.
#ifndef LOBE_BRDF_LOBE_H
#define LOBE_BRDF_LOBE_H

#include "brdf/brdf.h"
#include "brdf/heading.h"
#include "core/math.h"

// Finite sharpness ends here; above, a lobe is a mirror.
#define LOBE_LARGEST_N ((real)3e38f)

typedef struct {
    real x;  // 1 - cos phi
    real t;  // cos phi
} LobePoint;

LobePoint lobe_point(real3 wo, real3 wi) {
    real3 mirror = reflect_local(wo);
    real3 d = mirror - wi;
    LobePoint p;
    p.x = R(0.5) * dot(d, d);
    p.t = p.x < R(0.5) ? 1 - p.x : dot(mirror, wi);
    return p;
}

// The part of the circle at p about the mirror direction that lies above the horizon: an arc about
// its highest point, at least half the circle for t > 0. The circle, of sine s, dips below once s
// exceeds the mirror direction's height wo.z, or as well once t falls below its sine: of the equal
// differences s^2 - wo.z^2 and sine^2 - t^2 the one of smaller numbers is exact.
//
// With the azimuth uniform over this arc, lobe_direction(wo, p, arc * (u - 1/2)), a lobe of density
// q(p) has the density q(p) / arc above the horizon, and only rounding loses a sample below it.
real lobe_visible_arc(LobePoint p, real3 wo) {
    real beyond =
        p.x < R(0.5) ? p.x * (2 - p.x) - wo.z * wo.z : wo.x * wo.x + wo.y * wo.y - p.t * p.t;
    return beyond > 0 ? R(0.5) + 2 * real_angle(larger(p.t, 0) * wo.z, sqrt(beyond)) : 1;
}

// The direction at p, at `turns` around the mirror direction from its highest point.
real3 lobe_direction(real3 wo, LobePoint p, real turns) {
    real3 mirror = reflect_local(wo);
    real sine = sqrt(mirror.x * mirror.x + mirror.y * mirror.y);
    real2 heading = heading_of(mirror);
    real2 around = sqrt(p.x * (2 - p.x)) * real_circle(turns);
    real outward = -wo.z * around.x;  // the tangent towards the normal leans back along heading
    return (real3)(fma(p.t, mirror.x, outward * heading.x - around.y * heading.y),
                   fma(p.t, mirror.y, outward * heading.y + around.y * heading.x),
                   fma(p.t, wo.z, sine * around.x));
}

// How a lobe (x) and the diffuse part (y) share the samples: as their albedos. Both 0 if both are.
real2 lobe_choice(real specular_albedo, real diffuse_albedo) {
    real total = specular_albedo + diffuse_albedo;
    return total > 0 ? (real2)(specular_albedo, diffuse_albedo) / total : (real2)(0);
}

// A lobe that has become a mirror: taken with the given probability.
BrdfSample delta_sample(real3 wo, real3 reflectance, real probability) {
    BrdfSample sample = brdf_no_sample();
    sample.wi = reflect_local(wo);
    sample.pdf = probability;
    sample.weight = reflectance / probability;
    sample.delta = 1;
    return sample;
}

real mean_component(real3 c) { return (c.x + c.y + c.z) * (R(1.0) / 3); }

// A uniformly distributed cosine to the mirror direction: for lobes without a peak.
LobePoint lobe_uniform_point(real u) {
    LobePoint p;
    p.x = u;
    p.t = 1 - u;
    return p;
}

#endif
