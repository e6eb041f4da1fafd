// SPDX-License-Identifier: Apache-2.0
// What a scene must have before it is packed for the device.
#include <gtest/gtest.h>

#include "base/error.h"
#include "build/pack.h"
#include "support/probe.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

TEST(BuildPack, AMaterialHasOneRowForEachParameter) {
    const PackOptions options{read_brdf_tables(test_kernels())};
    Scene scene = small_scene(0.5);
    scene.materials.push_back(material("rational"));
    EXPECT_EQ(pack_scene(scene, options).rows.size(),
              scene.materials[0].rows.size() + scene.materials[1].rows.size());
    scene.materials[1].rows.pop_back();
    scene.materials[1].where = "scene.pbrt:3:1";
    try {
        pack_scene(scene, options);
        FAIL() << "a row is missing";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::internal);
        EXPECT_EQ(error.where(), "scene.pbrt:3:1");
    }
}
