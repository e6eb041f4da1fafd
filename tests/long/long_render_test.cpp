// SPDX-License-Identifier: Apache-2.0
// Sums of very many samples.
#include <gtest/gtest.h>

#include "report/estimate.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

// Ten million samples of a constant 0.1 in a film of 4x4: a float sum would be off by a hundredth.
TEST(LongRender, TenMillionSamplesStayExact) {
    Scene scene = small_scene(0.5, 4);
    scene.environment = glm::vec3(0.1f);
    PictureOptions options;
    options.samples = 10000000;
    options.general = false;
    const Picture picture = render_picture(scene, options);
    for (const float value : estimate(picture.film).rgb) EXPECT_NEAR(value, 0.1, 1e-7);
}
