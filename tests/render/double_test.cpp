// SPDX-License-Identifier: Apache-2.0
// What float loses: the same renderer, the same random numbers, in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "report/estimate.h"
#include "support/device.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

TEST(DoubleBuild, PicturesAgreePixelByPixel) {
    LOBE_NEEDS_DOUBLE();
    const Scene scene = busy_scene(40, true);
    PictureOptions options;
    options.general = false;
    const Picture single = render_picture(scene, options);
    options.double_precision = true;
    const Picture twice = render_picture(scene, options);
    EXPECT_NE(single.hash, twice.hash);
    const MeanOf a = mean_of(single), b = mean_of(twice);
    EXPECT_LT(std::abs(a.mean - b.mean), 3 * b.error);
    // The numbers are the same, so most pixels differ by roundings only; a path that takes another
    // way at an edge changes its pixel by about one sample.
    const Estimate x = estimate(single.film), y = estimate(twice.film);
    std::vector<double> differences;
    for (std::size_t i = 0; i < x.rgb.size(); ++i)
        differences.push_back(std::abs(x.rgb[i] - y.rgb[i]) / (std::abs(y.rgb[i]) + 1e-3));
    std::sort(differences.begin(), differences.end());
    EXPECT_LT(differences[differences.size() / 2], 1e-5);
    EXPECT_LT(differences[differences.size() * 9 / 10], 1e-3);
}
