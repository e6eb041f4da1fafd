// SPDX-License-Identifier: Apache-2.0
// The factor that makes a lobe f = g / max(cos theta_i, cos theta_o) of one that reflects g: a
// reciprocal stand-in for Phong's g / cos theta_i.
#ifndef LOBE_BRDF_STRETCH_H
#define LOBE_BRDF_STRETCH_H

#include "core/vec.h"

// cos theta_i / max(cos theta_i, cos theta_o), in (0, 1].
real stretched_cosine(real3 wo, real3 wi) { return wi.z < wo.z ? wi.z / wo.z : 1; }

#endif
