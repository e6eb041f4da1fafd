// SPDX-License-Identifier: Apache-2.0
// What a feature compiles in is what the picture gets from it: without, there is another picture.
#include <gtest/gtest.h>

#include "build/pack.h"
#include "report/estimate.h"
#include "support/device.h"
#include "support/probe.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Without one kind of shape its leaves are read as those of the other, so there must be as many.
Scene scene_with(Feature feature) {
    Scene scene = busy_scene(16, true);
    scene.filter = {FilterKind::mitchell, 2, 2};
    if (feature != Feature::TRIANGLES) return scene;
    scene = small_scene(0.5, 16);
    scene.environment = glm::vec3(1);
    add(scene, wall(4, 1));
    add(scene, {0.5, 0.5, 3}, 0.5);
    return scene;
}

std::string hash_of(const PackedScene& packed) {
    Session session(test_device(), test_kernels(), packed);
    RenderPlan plan;
    plan.samples = 8;
    return image_hash(estimate(render(session, plan).film));
}

}  // namespace

TEST(Features, EachIsSeenInThePictureThatNeedsIt) {
    for (std::size_t i = 0; i < FeatureSet().size(); ++i) {
        PackedScene packed = pack_scene(scene_with(static_cast<Feature>(i)));
        FeatureState& feature = packed.features[i];
        ASSERT_TRUE(feature.in) << feature.name;
        const std::string whole = hash_of(packed);
        feature.in = false;
        EXPECT_NE(hash_of(packed), whole) << feature.name;
    }
}
