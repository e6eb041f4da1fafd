// SPDX-License-Identifier: Apache-2.0
// The half vector h of two directions, and reflection about half vectors that face the viewer.
//
// Let q(h) be any density of half vectors that is the same for h and for h', which is h after half
// a turn about the normal: the other side of a V-shaped groove. Drawn from q, and then h or h'
// taken in proportion to how they face wo, half vectors have the density
//     2 q(h) o.h / (max(o.h, 0) + max(o.h', 0)) = 2 q(h) o.h / max(o.h, 2 h.z o.z),
// as o.h + o.h' = 2 h.z o.z. None is seen from behind. For q = D h.z these are exactly the normals
// that Torrance and Sparrow's V-shaped grooves show to wo (E. Heitz, E. d'Eon, "Importance sampling
// microfacet-based BSDFs using the distribution of visible normals", 2014).
#ifndef LOBE_CORE_HALF_VECTOR_H
#define LOBE_CORE_HALF_VECTOR_H

#include "core/vec.h"

// Densities grow as 1 / cosine towards grazing directions and would overflow below this.
#define HALF_VECTOR_TINY R(1e-18)

typedef struct {
    real2 slope;   // h.xy / h.z
    real cosine;   // h.z
    real length;   // |wo + wi|: twice the cosine of h to either direction
    real oblique;  // 1 - that cosine
} HalfVector;

// Of unit directions above the horizon. Nothing cancels; and the sum is measured in its largest
// component, as the squares of an almost opposite, grazing pair's underflow.
HalfVector half_vector(real3 wo, real3 wi) {
    real3 sum = wo + wi, difference = wo - wi;
    real most = larger(larger(fabs(sum.x), fabs(sum.y)), sum.z);
    real3 scaled = sum / most;
    real scaled_length = sqrt(dot(scaled, scaled));
    HalfVector h;
    h.slope = sum.xy / sum.z;
    h.cosine = scaled.z / scaled_length;
    h.length = most * scaled_length;
    h.oblique = dot(difference, difference) / (4 + 2 * h.length);
    return h;
}

// Density per solid angle of half_reflection over the density q of the half vectors it is given.
real half_reflection_density(HalfVector h, real wo_z) {
    return 1 / larger(larger(h.length, 4 * h.cosine * wo_z), HALF_VECTOR_TINY);
}

// wo mirrored about h or h', whichever u in [0, 1) takes; h.z > 0, of any length. Below the horizon
// is light lost to other facets.
real3 half_reflection(real3 wo, real3 h, real u) {
    real upright = wo.z * h.z, lateral = wo.x * h.x + wo.y * h.y;
    real better = upright + fabs(lateral), worse = larger(upright - fabs(lateral), 0);
    int take_better = u * (better + worse) <= better;
    real side = take_better == (lateral >= 0) ? 1 : -1;
    real across = h.x * h.x + h.y * h.y, up = h.z * h.z;
    real scale = 2 * (take_better ? better : worse) / (across + up);
    return (real3)(scale * side * h.x - wo.x, scale * side * h.y - wo.y,
                   (wo.z * (up - across) + 2 * side * lateral * h.z) /
                       (across + up));  // keeps a small wo.z
}

// Schlick's weight of white in Fresnel's reflectance, (1 - cosine)^5, from 1 - cosine.
real schlick_weight(real oblique) { return square(square(oblique)) * oblique; }

real3 schlick_fresnel(real3 normal_reflectance, real oblique) {
    return normal_reflectance + (1 - normal_reflectance) * schlick_weight(oblique);
}

#endif
