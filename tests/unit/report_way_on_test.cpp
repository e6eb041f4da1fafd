// SPDX-License-Identifier: Apache-2.0
#include "report/way_on.h"

#include <gtest/gtest.h>

using namespace lobe;

TEST(WayOn, NextRoundFigureBelow) {
    EXPECT_DOUBLE_EQ(round_below(0.019), 0.01);
    EXPECT_DOUBLE_EQ(round_below(0.01), 0.005);
    EXPECT_DOUBLE_EQ(round_below(0.0101), 0.01);
    EXPECT_DOUBLE_EQ(round_below(0.83), 0.5);
    EXPECT_DOUBLE_EQ(round_below(0.5), 0.2);
    EXPECT_DOUBLE_EQ(round_below(2), 1);
    EXPECT_DOUBLE_EQ(round_below(3e-7), 2e-7);
}

TEST(WayOn, TellsTheCostAndTheCommand) {
    const auto way = way_on(0.02, 10,
                            {"lobe", "render", "a b.pbrt", "--spp", "64", "-o", "x.exr", "--time=3",
                             "--error", "2%", "--seed", "7"});
    ASSERT_TRUE(way);
    EXPECT_DOUBLE_EQ(way->error, 0.01);
    EXPECT_NEAR(way->seconds, 40, 1e-9);
    EXPECT_NEAR(way->more_seconds, 30, 1e-9);
    EXPECT_EQ(way->command, "lobe render 'a b.pbrt' -o x.exr --seed 7 --error 1%");
    EXPECT_EQ(way_on(0.0023, 1, {"lobe"})->command, "lobe --error 0.2%");
    EXPECT_FALSE(way_on(0, 10, {}));
}

TEST(WayOn, Words) {
    EXPECT_EQ(shell_word("plain-word_1.exr"), "plain-word_1.exr");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("$HOME;ls"), "'$HOME;ls'");
    EXPECT_EQ(percent_text(0.01), "1 %");
    EXPECT_EQ(percent_text(0.0005), "0.05 %");
    EXPECT_EQ(seconds_text(0.2), "1 s");
    EXPECT_EQ(seconds_text(41.3), "41 s");
    EXPECT_EQ(seconds_text(400), "7 min");
    EXPECT_EQ(seconds_text(9000), "2.5 h");
}
