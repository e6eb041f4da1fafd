// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "base/luminance.h"
#include "report/chart/plot_style.h"

using namespace lobe;

TEST(PlotStyle, NumbersAreShort) {
    EXPECT_EQ(plot_number(0.25), "0.25");
    EXPECT_EQ(plot_number(-0.0), "0");
    EXPECT_EQ(plot_number(1000), "1000");
    EXPECT_EQ(plot_number(0.001), "0.001");
    EXPECT_EQ(plot_number(1e4), "10⁴");
    EXPECT_EQ(plot_number(1e6), "10⁶");
    EXPECT_EQ(plot_number(1e-12), "10⁻¹²");
    EXPECT_EQ(plot_number(2.5e7), "2.5·10⁷");
}

TEST(PlotStyle, AxesHaveAFewRoundTicks) {
    EXPECT_EQ((Axis{0, 1, 0, 1}.ticks()),
              (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1}));
    for (double high = 1e-6; high < 1e6; high *= 1.37) {
        const std::vector<double> ticks = Axis{0, high, 0, 1}.ticks();
        EXPECT_GE(ticks.size(), 3u) << high;
        EXPECT_LE(ticks.size(), 6u) << high;
        EXPECT_LE(ticks.back(), high * (1 + 1e-9));
    }
    EXPECT_EQ((Axis{0.01, 100, 0, 1, true}.ticks().size()), 5u);
    EXPECT_LE((Axis{1e-12, 1e12, 0, 1, true}.ticks().size()), 7u);
    EXPECT_DOUBLE_EQ((Axis{0.01, 100, 10, 50, true}.at(1)), 30);
    EXPECT_DOUBLE_EQ((Axis{0, 4, 100, 0}.at(1)), 75);
}

TEST(PlotStyle, TheOrderOfSeriesShowsInGrey) {
    for (const std::size_t count : {2u, 3u, 5u, 8u})
        for (std::size_t i = 1; i < count; ++i) {
            const Ink a = series_ink(i - 1, count), b = series_ink(i, count);
            const int rgb_a[] = {a.red, a.green, a.blue}, rgb_b[] = {b.red, b.green, b.blue};
            EXPECT_GT(luminance(rgb_b), luminance(rgb_a) + 5) << i << " of " << count;
        }
}

TEST(PlotStyle, LabelsStandFreeWhereThereIsRoom) {
    std::vector<Curve> curves;
    for (int k = 0; k < 4; ++k) {
        Curve curve{{}, series_ink(static_cast<std::size_t>(k), 4), "label"};
        for (int i = 0; i <= 100; ++i) curve.points.push_back({3.0 * i, 20 + 60.0 * k + 0.1 * i});
        curves.push_back(curve);
    }
    Drawing drawing;
    add_labels(drawing, curves, {0, 0}, {300, 250});
    ASSERT_EQ(drawing.texts.size(), 4u);
    for (std::size_t a = 0; a < 4; ++a) {
        const Text& text = drawing.texts[a];
        const double half = text_width(text.text, text.size) / 2;
        EXPECT_GE(text.at.x - half, 0);
        EXPECT_LE(text.at.x + half, 300);
        double own = 1e9;
        for (std::size_t b = 0; b < 4; ++b)
            for (const glm::dvec2& p : curves[b].points) {
                const bool covered = std::abs(p.x - text.at.x) < half && p.y < text.at.y &&
                                     p.y > text.at.y - 0.75 * text.size;
                EXPECT_FALSE(covered) << a << " over " << b;
                const double far = glm::distance(p, text.at);
                if (b == a)
                    own = std::min(own, far);
                else
                    EXPECT_GT(far, 20) << a << " near " << b;
            }
        EXPECT_LT(own, half + 15);
    }
}

TEST(PlotStyle, LongTextsAreCutToTheWidth) {
    EXPECT_EQ(fitted("short", 10, 100), "short");
    const std::string cut = fitted("kd 0.1, ks 0.2, n 100, lobe abs, normalize true", 10, 100);
    EXPECT_LE(text_width(cut, 10), 100);
    EXPECT_EQ(cut.substr(cut.size() - 3), "...");
}
