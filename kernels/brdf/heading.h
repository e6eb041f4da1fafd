// SPDX-License-Identifier: Apache-2.0
// The direction of a vector along the surface.
#ifndef LOBE_BRDF_HEADING_H
#define LOBE_BRDF_HEADING_H

#include "core/vec.h"

// The unit vector of w along the surface: any, if w is so near the normal that its squares
// underflow.
real2 heading_of(real3 w) {
    real sine = sqrt(w.x * w.x + w.y * w.y);
    return sine > R(1e-18) ? w.xy / sine : (real2)(1, 0);
}

#endif
