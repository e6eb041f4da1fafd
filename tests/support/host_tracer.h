// SPDX-License-Identifier: Apache-2.0
// A second path tracer: on the host, in double, without a hierarchy, without choosing lights by
// power and without combining strategies. It knows lambertian materials, triangles and spheres,
// shining ones too, point and distant lights and an even sky. Slow, short and plain on purpose.
#pragma once

#include "support/render_rig.h"

namespace lobe::test {

// Renders with `samples` per pixel. A shining shape is found by the path alone (`by_chance`) or by
// a uniform choice of a point on one of them.
Picture trace_on_host(const Scene& scene, std::uint32_t samples, std::uint64_t seed,
                      bool by_chance = true);

}  // namespace lobe::test
