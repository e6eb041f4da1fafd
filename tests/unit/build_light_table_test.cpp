// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "build/light_table.h"
#include "base/random.h"

using namespace lobe;

namespace {

std::vector<PoweredLight> lights_of(const std::vector<double>& powers) {
    std::vector<PoweredLight> lights;
    for (const double power : powers) lights.push_back({LobeLight{}, power});
    return lights;
}

// What the kernels rely on: whole grains, none negative, at least one where there is power, each
// probability exactly the step of the running sum, which ends at 1.
void expect_sound(const std::vector<double>& powers) {
    const LightTable table = make_light_table(lights_of(powers));
    ASSERT_EQ(table.lights.size(), powers.size());
    ASSERT_EQ(table.sums.size(), powers.size());
    double total = 0, before = 0;
    for (const double power : powers) total += power;
    for (std::size_t i = 0; i < powers.size(); ++i) {
        const double p = table.lights[i].probability, grains = std::ldexp(p, 24);
        ASSERT_EQ(grains, std::floor(grains)) << "light " << i;
        ASSERT_EQ(table.sums[i] - before, p) << "light " << i;
        ASSERT_GE(grains, powers[i] > 0 ? 1 : 0) << "light " << i;
        if (powers[i] == 0) {
            ASSERT_EQ(p, 0) << "light " << i;
        }
        // One grain each, a rounding at either end, and the share of the grains given so.
        const double slack = std::ldexp(2.5 + double(powers.size()) * powers[i] / total, -24);
        ASSERT_NEAR(p, powers[i] / total, slack) << "light " << i;
        before = table.sums[i];
    }
    EXPECT_EQ(table.sums.back(), 1.0f);
}

}  // namespace

TEST(BuildLightTable, AFewLights) {
    expect_sound({1});
    expect_sound({1, 1, 1});
    expect_sound({1, 2, 5});
    expect_sound({0, 3, 0, 1, 0});
    expect_sound({1e-30, 1e30});
    expect_sound({1e30, 1e-30, 1e-30});
    expect_sound({1e-300, 2e-300});
}

// A mesh light of many equal triangles, whose equal shares all round the same way.
TEST(BuildLightTable, ManyEqualLights) {
    for (const int count : {1000, 6001, 10000, 65537, 300000})
        expect_sound(std::vector<double>(count, 0.7));
}

TEST(BuildLightTable, ManyFaintLightsBesideABrightOne) {
    std::vector<double> powers(100000, 1e-12);
    powers[500] = 1;
    expect_sound(powers);
}

TEST(BuildLightTable, RandomPowers) {
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        std::vector<double> powers;
        const std::uint32_t count = 1 + random.below(2000);
        for (std::uint32_t k = 0; k < count; ++k)
            powers.push_back(random.below(5) ? random.log_uniform(1e-6, 1e6) : 0);
        powers[0] = 1;
        expect_sound(powers);
    }
}

TEST(BuildLightTable, WithoutPowerThereIsNoTable) {
    EXPECT_TRUE(make_light_table({}).lights.empty());
    EXPECT_TRUE(make_light_table(lights_of({0, 0})).lights.empty());
}
