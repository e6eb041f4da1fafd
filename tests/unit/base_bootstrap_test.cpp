// SPDX-License-Identifier: Apache-2.0
// Whether the intervals hold what they should, for laws that are not normal.
#include "base/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "base/statistics.h"

using namespace lobe;

namespace {

// Of `trials` 95 % intervals of the mean of `runs` values of mean 1, the part that holds it.
template <typename Draw>
double coverage(std::size_t runs, int trials, const Draw& draw) {
    int held = 0;
    BootstrapOptions options;
    options.resamples = 1000;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> values(runs);
        for (double& value : values) value = draw();
        options.seed = static_cast<std::uint64_t>(trial);
        held += bootstrap_mean(values, options).holds(1);
    }
    return static_cast<double>(held) / trials;
}

}  // namespace

// The simulation's own standard error is .005.
TEST(Bootstrap, IntervalsCover) {
    Random random(1);
    EXPECT_NEAR(coverage(16, 2000, [&] { return 1 + random.normal(); }), 0.95, 0.02);
    EXPECT_NEAR(coverage(20, 2000, [&] { return 2 * random.uniform(); }), 0.95, 0.02);
    // Exponential: leans to the right, where mean +- t * error holds only .926 for 16 runs.
    EXPECT_NEAR(coverage(16, 2000, [&] { return -std::log1p(-random.uniform()); }), 0.95, 0.025);
}

TEST(Bootstrap, LeansAsTheDataDo) {
    const Interval interval = bootstrap_mean({1, 1, 1, 1, 2, 1, 1, 3, 1, 9});
    EXPECT_LT(interval.low, 2.1);
    EXPECT_GT(interval.high - 2.1, 2 * (2.1 - interval.low));
}

TEST(Bootstrap, IsRepeatableAndNarrowsWithRuns) {
    Random random(3);
    std::vector<double> few, many;
    for (int i = 0; i < 16; ++i) few.push_back(random.normal());
    for (int i = 0; i < 256; ++i) many.push_back(random.normal());
    const Interval a = bootstrap_mean(few), b = bootstrap_mean(few), c = bootstrap_mean(many);
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
    EXPECT_NEAR((c.high - c.low) / (a.high - a.low), 0.25, 0.1);
}

TEST(Bootstrap, FiguresAreResampledTogether) {
    const std::vector<double> x = {1, 2, 3, 4, 5, 7, 9, 12};
    bool paired = true;
    const auto intervals = bootstrap(x.size(), [&](const std::vector<std::size_t>& chosen) {
        std::vector<double> drawn, mirrored;
        for (const std::size_t i : chosen) {
            drawn.push_back(x[i]);
            mirrored.push_back(-x[i]);
        }
        paired &= mean(drawn) == -mean(mirrored);
        return std::vector<Studentised>{studentised_mean(drawn), studentised_mean(mirrored)};
    });
    EXPECT_TRUE(paired);
    EXPECT_NEAR(intervals[0].low, -intervals[1].high, 0.05);
    EXPECT_NEAR(intervals[0].high, -intervals[1].low, 0.05);
}

TEST(Bootstrap, SaysNothingWhereThereIsNothing) {
    EXPECT_TRUE(std::isnan(bootstrap_mean({1, 2}).low));
    EXPECT_TRUE(std::isnan(bootstrap_mean({1, 1, 1, 1}).low));
    EXPECT_TRUE(std::isnan(bootstrap_mean({1, 2, NAN, 1}).low));
}
