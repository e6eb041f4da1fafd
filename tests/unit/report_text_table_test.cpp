// SPDX-License-Identifier: Apache-2.0
// Tables and sparklines.
#include "report/text_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "report/sparkline.h"
#include "support/temp_folder.h"

using namespace lobe;
using namespace lobe::test;

TEST(ReportTextTable, NumbersStandToTheRight) {
    TextTable table({"name", "value", "share", "note"});
    table.add({"one", "1.5", "-3 %", "7 of 9 are words"});
    table.add({"fourteen", "-123", "unknown", "none of them"});
    table.add({"", "< 1e-9", "", "±2"});
    EXPECT_EQ(table.text(),
              "name       value    share  note\n"
              "one          1.5     -3 %  7 of 9 are words\n"
              "fourteen    -123  unknown  none of them\n"
              "          < 1e-9           ±2\n");
}

TEST(ReportTextTable, CharactersCountNotBytes) {
    TextTable table({"α", "x"});
    table.add({"größe", "µ"});
    table.add({"日本", "y"});
    table.add({"e\u0301", "z"});
    EXPECT_EQ(table.text(), "α      x\ngröße  µ\n日本   y\ne\u0301      z\n");
    EXPECT_EQ(text_width("größe"), 5u);
    EXPECT_EQ(text_width("日本"), 4u);
    EXPECT_EQ(text_width("e\u0301"), 1u);
    EXPECT_EQ(text_width("█▁±"), 3u);
    EXPECT_EQ(text_width("\U0001f600"), 2u);
    EXPECT_EQ(text_width("\xff\xc3"), 2u);  // no UTF-8
    EXPECT_EQ(text_width("\xe2\x96"), 2u);  // a character cut short
}

TEST(ReportTextTable, RowsMayBeShortNotLong) {
    TextTable table({"a", "b"});
    table.add({"1"});
    EXPECT_EQ(table.text(), "a  b\n1\n");
    EXPECT_THROW(table.add({"1", "2", "3"}), Error);
    EXPECT_EQ(TextTable({"only", "head"}).text(), "only  head\n");
    TextTable words({"a", "b"});
    words.add({"1", "12"});
    words.add({"2", "and a word"});  // one word puts the column to the left
    EXPECT_EQ(words.text(), "a  b\n1  12\n2  and a word\n");
}

TEST(ReportSparkline, BarsAreAsHighAsTheValues) {
    using S = SparkSet;
    EXPECT_EQ(sparkline({0, 1, 2, 3, 4, 5, 6, 7}, SparkScale::linear, S::blocks), "▁▂▃▄▅▆▇█");
    EXPECT_EQ(sparkline({3, -1, 7}, SparkScale::linear, S::blocks), "▅▁█");
    EXPECT_EQ(sparkline({1, 10, 100, 1000}, SparkScale::logarithmic, S::blocks), "▁▃▆█");
    EXPECT_EQ(sparkline({1, 10, 100, 1000}, SparkScale::linear, S::blocks), "▁▁▁█");
    EXPECT_EQ(sparkline({0, 1, 2, 3, 4, 5}, SparkScale::linear, S::ascii), "_.-=*#");
    EXPECT_EQ(sparkline({}, SparkScale::linear, S::blocks), "");
    EXPECT_EQ(sparkline({2, 2}, SparkScale::linear, S::blocks), "▅▅");
}

TEST(ReportSparkline, WhatHasNoPlaceIsASpace) {
    const double nan = std::nan(""), huge = std::numeric_limits<double>::max();
    EXPECT_EQ(sparkline({1, nan, 2, INFINITY}, SparkScale::linear, SparkSet::blocks), "▁ █ ");
    EXPECT_EQ(sparkline({0, 1, -1, 2}, SparkScale::logarithmic, SparkSet::blocks), " ▁ █");
    EXPECT_EQ(sparkline({nan, nan}, SparkScale::linear, SparkSet::blocks), "  ");
    EXPECT_EQ(sparkline({-huge, 0, huge}, SparkScale::linear, SparkSet::blocks), "▁▅█");
}

TEST(ReportSparkline, LocaleChoosesTheCharacters) {
    ScopedVariable all("LC_ALL", nullptr), type("LC_CTYPE", nullptr), lang("LANG", nullptr);
    EXPECT_FALSE(locale_is_utf8());
    EXPECT_EQ(sparkline({1, 2}), "_#");
    ScopedVariable german("LANG", "de_DE.UTF-8");
    EXPECT_TRUE(locale_is_utf8());
    EXPECT_EQ(sparkline({1, 2}), "▁█");
    {
        ScopedVariable plain("LC_CTYPE", "C");
        EXPECT_FALSE(locale_is_utf8());
        ScopedVariable over("LC_ALL", "C.utf8");
        EXPECT_TRUE(locale_is_utf8());
        ScopedVariable empty("LC_ALL", "");
        EXPECT_FALSE(locale_is_utf8());
    }
    EXPECT_EQ(sparkline({1, 2}, SparkScale::linear, SparkSet::ascii), "_#");
}
