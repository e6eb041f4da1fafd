// SPDX-License-Identifier: Apache-2.0
// Adding samples to a pixel, after asking whether they are what radiance can be.
#ifndef LOBE_PATH_FILM_H
#define LOBE_PATH_FILM_H

#include "core/vec.h"
#include "shared/frame.h"
#include "shared/status.h"

void raise_status(global uint* status, uint counter, uint pixel, uint sample) {
    atomic_inc(&status[counter]);
    if (atomic_cmpxchg(&status[LOBE_STATUS_PIXEL], 0u, pixel + 1) == 0) {
        status[LOBE_STATUS_SAMPLE] = sample;
    }
}

// Adds a sample. A non-finite one is counted and adds nothing; a negative one is counted and added.
void add_sample(LobeBlockSum* sum, real3 radiance, real weight, int emitter, global uint* status,
                uint pixel, uint sample) {
    sum->emitter += emitter ? 1.0f : 0.0f;
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
