// SPDX-License-Identifier: Apache-2.0
// What of the kernel a scene gets: what it needs, and what is forced in.
#include <gtest/gtest.h>

#include "base/error.h"
#include "build/feature_check.h"
#include "study/bench/feature_costs.h"
#include "support/probe.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

Scene scene_of_everything() {
    Scene scene = busy_scene(8, true);
    scene.filter = {FilterKind::mitchell, 2, 2};
    return scene;
}

PackOptions all_models_at_hand() { return {read_brdf_tables(test_kernels())}; }

const FeatureState& state(const PackedScene& packed, Feature feature) {
    return packed.features[static_cast<std::size_t>(feature)];
}

}  // namespace

TEST(BuildFeatures, ForcingAddsOneFeatureAndNothingElse) {
    Scene scene = small_scene(0.5);
    add(scene, wall(4, 1));
    PackOptions options = all_models_at_hand();
    const PackedScene own = pack_scene(scene, options);
    options.forced = {Feature::THIN_LENS, Feature::TRIANGLES};
    const PackedScene forced = pack_scene(scene, options);
    EXPECT_FALSE(state(own, Feature::THIN_LENS).in);
    EXPECT_TRUE(state(forced, Feature::THIN_LENS).in);
    EXPECT_EQ(state(forced, Feature::THIN_LENS).reason, "forced");
    EXPECT_EQ(state(forced, Feature::TRIANGLES).reason, state(own, Feature::TRIANGLES).reason);
    for (std::size_t i = 0; i < own.features.size(); ++i) {
        if (static_cast<Feature>(i) == Feature::THIN_LENS) continue;
        EXPECT_EQ(forced.features[i].in, own.features[i].in) << own.features[i].name;
    }
    EXPECT_EQ(forced.models.size(), own.models.size());
}

TEST(BuildFeatures, AllModelsAddNoFeature) {
    Scene scene = small_scene(0.5);
    PackOptions options = all_models_at_hand();
    options.all_models = true;
    const PackedScene packed = pack_scene(scene, options);
    EXPECT_EQ(packed.models.size(), options.models.size());
    EXPECT_EQ(packed.models.at(packed.materials.at(0).model).name, "lambert");
    EXPECT_FALSE(state(packed, Feature::SPHERES).in);
}

// The scene has everything, so each feature that there is, now or later, must be missed.
TEST(BuildFeatures, WhatIsLeftOutButNeededIsMissed) {
    PackedScene packed = pack_scene(scene_of_everything(), all_models_at_hand());
    EXPECT_NO_THROW(check_features(packed));
    for (std::size_t i = 0; i < packed.features.size(); ++i) {
        if (is_hint(static_cast<Feature>(i))) continue;
        FeatureState& feature = packed.features[i];
        EXPECT_TRUE(feature.in) << feature.name;
        feature.in = false;
        try {
            check_features(packed);
            ADD_FAILURE() << feature.name << " is not missed";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::internal);
            EXPECT_NE(std::string(error.what()).find(feature.name), std::string::npos);
        }
        feature.in = true;
    }
}

// The kernel is compiled before the scene is packed.
TEST(BuildFeatures, NeedsAreKnownBeforeTheSceneIsPacked) {
    Scene scene = scene_of_everything();
    PackOptions options = all_models_at_hand();
    for (const bool all : {false, true}) {
        options.all_features = all;
        const KernelNeeds needs = kernel_needs(scene, options);
        const PackedScene packed = pack_scene(scene, options);
        EXPECT_EQ(scene_header(needs.features, needs.models, needs.integrator),
                  scene_header(packed.features, packed.models, packed.integrator));
        EXPECT_EQ(needs.models.size() == options.models.size(), all);
    }
}

TEST(BuildFeatures, AVariantForEachPartLeftOut) {
    const PackOptions options = all_models_at_hand();
    Scene scene = scene_of_everything();
    scene.camera.lens_radius = 0;
    scene.distant_lights.clear();
    const auto variants = kernel_variants(scene, options);
    std::string names;
    for (const KernelVariant& variant : variants) names += variant.name + ", ";
    ASSERT_EQ(names, "FETCH_AHEAD, DISTANT_LIGHTS, THIN_LENS, all models, everything, ");
    EXPECT_EQ(variants[1].pack.forced, std::vector<Feature>{Feature::DISTANT_LIGHTS});
    EXPECT_TRUE(variants[3].pack.all_models);
    EXPECT_TRUE(variants[4].pack.all_features);
}

TEST(BuildFeatures, NoVariantIsTheSameAsAnother) {
    PackOptions options = all_models_at_hand();
    options.forced = {Feature::FETCH_AHEAD};
    EXPECT_EQ(kernel_variants(scene_of_everything(), options).size(), 1u);  // all models
    for (BrdfTable& model : std::vector<BrdfTable>(std::move(options.models)))
        if (model.name == "lambert") options.models = {model};
    EXPECT_TRUE(kernel_variants(scene_of_everything(), options).empty());
    Scene pinhole = scene_of_everything();
    pinhole.camera.lens_radius = 0;
    EXPECT_EQ(kernel_variants(pinhole, options).size(), 1u);  // with the lens it has everything
    options.all_features = true;
    EXPECT_TRUE(kernel_variants(pinhole, options).empty());
}
