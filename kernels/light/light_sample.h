// SPDX-License-Identifier: Apache-2.0
// What sampling any light gives.
#ifndef LOBE_LIGHT_LIGHT_SAMPLE_H
#define LOBE_LIGHT_LIGHT_SAMPLE_H

#include "core/warp.h"
#include "geom/surface.h"

typedef struct {
    real3 towards;   // unit
    real distance;   // to the light along it
    real3 radiance;  // arriving if nothing stands in the way (of a delta light: irradiance)
    real pdf;        // per solid angle; of a delta light: probability; 0: no sample
    int delta;       // no other strategy can find this light
    uint primitive;  // that the shadow ray may meet: the light itself
} LightSample;

LightSample no_light_sample(void) {
    LightSample sample;
    sample.towards = (real3)(0, 0, 1);
    sample.distance = 0;
    sample.radiance = (real3)(0);
    sample.pdf = 0;
    sample.delta = 0;
    sample.primitive = LOBE_NONE;
    return sample;
}

#endif
