// SPDX-License-Identifier: Apache-2.0
// Rays as a path tracer sends them, in its order: what all tracers are measured with.
#pragma once

#include <string>
#include <vector>

#include "support/embree_scene.h"
#include "support/trace_rig.h"

namespace lobe::bench {

struct RayClass {
    std::string name;
    bool any;  // only whether something is met
    std::vector<test::TestRay> rays;
};

// Of a pinhole camera of side x side rays, in blocks of 4 x 2, that looks at the middle of the
// mesh: primary rays; from what these meet, shadow rays to a small square above and rays of random
// cosine direction; and from what the latter meet, such rays again. Origins are moved off the
// surface, so that no tracer needs to know where a ray begins.
std::vector<RayClass> ray_classes(const Mesh& mesh, const test::EmbreeScene& embree, unsigned side);

}  // namespace lobe::bench
