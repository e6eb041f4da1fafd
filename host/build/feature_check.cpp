// SPDX-License-Identifier: Apache-2.0
#include "build/feature_check.h"

#include <algorithm>

#include "base/error.h"

namespace lobe {

void check_features(const PackedScene& packed) {
    const auto check = [&](Feature feature, bool needed) {
        const FeatureState& state = packed.features[static_cast<std::size_t>(feature)];
        if (needed && !state.in)
            throw Error(ExitCode::internal, "the scene needs what is compiled out: " + state.name,
                        "", "render with --features all and report this as a fault of lobe");
    };
    const auto& lights = packed.lights.lights;
    const auto has_light = [&](LobeUint kind) {
        return std::any_of(lights.begin(), lights.end(),
                           [&](const LobeLight& light) { return light.kind == kind; });
    };
    const LobeFrame& frame = packed.frame;
    check(Feature::TRIANGLES, !packed.triangles.empty());
    check(Feature::SPHERES, !packed.spheres.empty());
    check(Feature::TRIANGLE_LIGHTS, has_light(LOBE_LIGHT_TRIANGLE));
    check(Feature::SPHERE_LIGHTS, has_light(LOBE_LIGHT_SPHERE));
    check(Feature::POINT_LIGHTS, has_light(LOBE_LIGHT_POINT));
    check(Feature::DISTANT_LIGHTS, has_light(LOBE_LIGHT_DISTANT));
    check(Feature::MANY_LIGHTS, lights.size() > 1);
    check(Feature::THIN_LENS, frame.lens_radius > 0);
}

}  // namespace lobe
