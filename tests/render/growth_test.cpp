// SPDX-License-Identifier: Apache-2.0
// Series of renders that grow, and where they end.
#include <gtest/gtest.h>

#include "base/error.h"
#include "study/bench/growth.h"
#include "support/device.h"
#include "support/probe.h"

using namespace lobe;
using namespace lobe::test;

TEST(Growth, ASizeThatTheHostCannotHoldEndsItsSeries) {
    GrowthPlan plan = short_growth();
    plan.triangles = plan.lights = plan.samples = {8};
    plan.film = {16, std::size_t{1} << 24, 32};
    const auto growth = measure_growth(test_device(), test_kernels(), plan);
    ASSERT_EQ(growth.size(), 4u);
    EXPECT_EQ(growth[2].points.size(), 1u);
    EXPECT_EQ(growth[2].end.rfind("16777216: the film needs ", 0), 0u) << growth[2].end;
    EXPECT_EQ(growth[3].end, "");
    plan.film = {std::size_t{1} << 24};
    EXPECT_THROW(measure_growth(test_device(), test_kernels(), plan), Error);
}

TEST(Growth, AStopLeavesOutWhatItCutsShort) {
    EXPECT_TRUE(
        measure_growth(test_device(), test_kernels(), short_growth(), [] { return true; }).empty());
}
