// SPDX-License-Identifier: Apache-2.0
// What a feature compiles in is what the picture gets from it: without, there is another picture.
// A hint gives the same picture.
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
        PackOptions options;
        options.forced = {static_cast<Feature>(i)};
        PackedScene packed = pack_scene(scene_with(static_cast<Feature>(i)), options);
        FeatureState& feature = packed.features[i];
        const bool hint = is_hint(static_cast<Feature>(i));
        ASSERT_EQ(feature.reason == "forced", hint) << feature.name;
        const std::string whole = hash_of(packed);
        feature.in = false;
        EXPECT_EQ(hash_of(packed) == whole, hint) << feature.name;
    }
}

TEST(Features, ASceneOfSpheresCarriesNoTriangleCode) {
    Scene balls = small_scene(0.5, 16);
    balls.environment = glm::vec3(1);
    add(balls, {0, 0, 4}, 1);
    PackOptions options;
    const PackedScene own = pack_scene(balls, options);
    options.forced = {Feature::TRIANGLES};
    const PackedScene more = pack_scene(balls, options);
    for (const auto* packed : {&own, &more}) {
        EXPECT_TRUE(packed->triangles.empty() && packed->vertices.empty());
        EXPECT_TRUE(packed->bvh.triangle_leaves.empty() && packed->filter_nodes.empty());
    }
    EXPECT_EQ(hash_of(own), hash_of(more));
    const Session without(test_device(), test_kernels(), own);
    const Session with(test_device(), test_kernels(), more);
    EXPECT_EQ(without.device_bytes(), with.device_bytes());
    const auto less_bytes = without.binary_bytes(), more_bytes = with.binary_bytes();
    if (!less_bytes || !more_bytes) GTEST_SKIP() << "the device tells no size of binaries";
    EXPECT_LT(*less_bytes, *more_bytes);  // 285 kB and 298 kB with PoCL 3.1
}
