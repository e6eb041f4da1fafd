// SPDX-License-Identifier: Apache-2.0
// Adding samples to a pixel, after asking whether they are what radiance can be.
#ifndef LOBE_PATH_FILM_H
#define LOBE_PATH_FILM_H

#include "path/path.h"
#include "shared/frame.h"
#include "shared/status.h"

void raise_status(global uint* status, uint counter, uint pixel, uint sample) {
    atomic_inc(&status[counter]);
    if (atomic_cmpxchg(&status[LOBE_STATUS_PIXEL], 0u, pixel + 1) == 0) {
        status[LOBE_STATUS_SAMPLE] = sample;
    }
}

// Adds what a path brought. What is not finite is counted and adds nothing; what is negative is
// counted and added.
void add_sample(LobeBlockSum* sum, const Path* path, global uint* status, uint pixel, uint sample) {
    real3 radiance = path->radiance;
    real weight = path->weight;
    sum->emitter += path->emitter ? 1.0f : 0.0f;
    real total = weight * (radiance.x + radiance.y + radiance.z);
    if (!isfinite(total)) {
        raise_status(status, LOBE_STATUS_NONFINITE, pixel, sample);
        return;
    }
    if (radiance.x < 0 || radiance.y < 0 || radiance.z < 0) {
        raise_status(status, LOBE_STATUS_NEGATIVE, pixel, sample);
    }
    sum->r += (float)(weight * radiance.x);
    sum->g += (float)(weight * radiance.y);
    sum->b += (float)(weight * radiance.z);
}

#endif
