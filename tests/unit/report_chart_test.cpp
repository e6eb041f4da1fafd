// SPDX-License-Identifier: Apache-2.0
// Charts: where their points stand, and that nothing leaves the paper.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "report/chart/bar_chart.h"
#include "report/chart/frame.h"
#include "report/chart/histogram.h"
#include "report/chart/interval_chart.h"
#include "report/chart/line_chart.h"
#include "report/image_io.h"
#include "report/raster.h"
#include "report/svg.h"

using namespace lobe;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void expect_on_paper(const Drawing& d) {
    const auto inside = [&](const glm::dvec2& p) {
        EXPECT_TRUE(p.x >= -1e-9 && p.x <= d.width + 1e-9 && p.y >= -1e-9 && p.y <= d.height + 1e-9)
            << d.title << ": " << p.x << " " << p.y;
    };
    for (const Area& area : d.areas)
        for (const glm::dvec2& p : area.points) inside(p);
    for (const Polyline& line : d.lines)
        for (const glm::dvec2& p : line.points) inside(p);
    for (const Dot& dot : d.dots) inside(dot.centre);
    for (const Text& text : d.texts) {
        const double width = text_width(text.text, text.size);
        const double left = text.at.x - width * 0.5 * static_cast<int>(text.anchor);
        inside({left, text.at.y});
        inside({left + width, text.at.y});
    }
}

bool says(const Drawing& d, const std::string& words) {
    for (const Text& text : d.texts)
        if (text.text == words) return true;
    return false;
}

LineChart falling() {
    LineChart chart{"Error against time", "seconds", "relative error", {}, true, true, -0.5, {}};
    for (int k = 0; k < 3; ++k) {
        ChartSeries series{"arm " + std::to_string(k), {}, {}};
        for (int i = 0; i < 8; ++i) {
            const double x = 0.1 * std::pow(2.0, i), y = (1 + k) * 0.2 / std::sqrt(x);
            series.points.push_back({x, y});
            series.band.push_back({0.9 * y, 1.1 * y});
        }
        chart.series.push_back(series);
    }
    return chart;
}

}  // namespace

TEST(LineChart, APowerLawIsAStraightLineBesideTheGuide) {
    const Drawing d = draw(falling());
    expect_on_paper(d);
    ASSERT_EQ(d.areas.size(), 3u);
    ASSERT_EQ(d.dots.size(), 24u);
    const auto slope = [](const glm::dvec2& a, const glm::dvec2& b) {
        return (b.y - a.y) / (b.x - a.x);
    };
    const double one = slope(d.dots[0].centre, d.dots[1].centre);
    for (std::size_t i = 1; i < 8; ++i)
        EXPECT_NEAR(slope(d.dots[0].centre, d.dots[i].centre), one, 1e-9);
    for (const Polyline& line : d.lines) {
        if (line.width != 1.2) continue;  // the guide's dashes
        EXPECT_NEAR(slope(line.points[0], line.points[1]), one, 1e-9);
    }
    for (const char* words : {"arm 0", "arm 1", "arm 2", "slope −1/2", "seconds"})
        EXPECT_TRUE(says(d, words)) << words;
    // Higher values stand higher.
    EXPECT_LT(d.dots[16].centre.y, d.dots[8].centre.y);
    // A band holds its curve.
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_LT(d.areas[0].points[i].y, d.dots[i].centre.y);
        EXPECT_GT(d.areas[0].points[15 - i].y, d.dots[i].centre.y);
    }
}

TEST(LineChart, WhatALogarithmCannotShowBreaksTheCurve) {
    LineChart chart = falling();
    chart.series[0].points[3].y = -1;
    chart.series[0].band[5].x = -0.5;
    chart.series[1].points[7].y = none;
    chart.series[2].points[0].x = 0;
    const Drawing d = draw(chart);
    expect_on_paper(d);
    EXPECT_EQ(d.dots.size(), 21u);
    EXPECT_EQ(d.areas.size(), 4u);
    EXPECT_TRUE(says(d, "arm 0"));
    expect_on_paper(draw(LineChart{"empty", "x", "y", {}, true, true, -0.5, {}}));
    expect_on_paper(draw(LineChart{"one", "x", "y", {{"a", {{1, 1}}, {}}}, true, true, -0.5, 0.1}));
}

TEST(ChartAxis, ARangeHoldsItsValuesAndHasTicks) {
    for (const auto& values : {std::vector<double>{1e-9, 1e9}, {3, 4}, {0.7}, {5, 5.001}, {}})
        for (const bool log : {false, true}) {
            const glm::dvec2 range = axis_range(values, log);
            for (const double value : values) {
                EXPECT_LT(range.x, value);
                EXPECT_GT(range.y, value);
            }
            EXPECT_GE((Axis{range.x, range.y, 0, 1, log}.ticks().size()), 2u) << range.x;
            EXPECT_LE((Axis{range.x, range.y, 0, 1, log}.ticks().size()), 11u) << range.x;
        }
}

TEST(Histogram, CountsAndHeightsAgree) {
    Histogram h{"p-values", "p", {0, 0.01, 0.5, 0.99, 1, none, 1.5, -0.1}, 0, 1, 4, false};
    EXPECT_EQ(counts(h), (std::vector<std::size_t>{2, 0, 1, 2}));
    const Drawing d = draw(h);
    expect_on_paper(d);
    ASSERT_EQ(d.areas.size(), 3u);
    const auto height = [&](std::size_t i) {
        return d.areas[i].points[0].y - d.areas[i].points[1].y;
    };
    EXPECT_NEAR(height(0), 2 * height(1), 1e-9);
    EXPECT_NEAR(height(0), height(2), 1e-9);
    h.uniform_band = true;
    EXPECT_EQ(draw(h).areas.size(), 4u);
    expect_on_paper(draw(h));
    h.values.clear();
    expect_on_paper(draw(h));
}

TEST(BarChart, LengthsAreTheValues) {
    const BarChart chart{"Costs", "seconds", {"a", "b"}, {{"x", {1, 3}}, {"y", {0.5, none}}}};
    const Drawing d = draw(chart);
    expect_on_paper(d);
    ASSERT_EQ(d.areas.size(), 5u);  // two of the legend
    const auto length = [&](std::size_t i) {
        return d.areas[i].points[1].x - d.areas[i].points[0].x;
    };
    EXPECT_NEAR(length(3), 3 * length(2), 1e-9);
    EXPECT_NEAR(length(4), 0.5 * length(2), 1e-9);
    EXPECT_EQ(d.areas[3].points[0].x, d.areas[2].points[1].x);
    EXPECT_TRUE(says(d, "4"));
    EXPECT_TRUE(says(d, "0.5"));
    expect_on_paper(draw(BarChart{"none", "s", {"a"}, {{"x", {0}}}}));
}

TEST(IntervalChart, ShowsWhatIsThere) {
    const IntervalChart chart{"Ratio",
                              "A over B",
                              {{"one", 0.8, 0.9, 1.1, "UNDECIDED"},
                               {"two", 1.5, 2, 2.5, "WIN"},
                               {"three", -1, 1.2, INFINITY, "UNDECIDED"},
                               {"four", none, none, none, "UNDECIDED"}}};
    const Drawing d = draw(chart);
    expect_on_paper(d);
    EXPECT_EQ(d.dots.size(), 3u);
    EXPECT_LT(d.dots[0].centre.x, d.dots[1].centre.x);
    EXPECT_TRUE(says(d, "four"));
}

TEST(Area, SvgAndPixelsHoldTheSameInk) {
    Drawing d;
    d.width = d.height = 60;
    d.add(Area{{{10, 10}, {50, 10}, {50, 30}, {10, 30}}, {0, 0, 0}, 0.25});
    EXPECT_NE(to_svg(d).find("<polygon points=\"10,10 50,10 50,30 10,30\" fill=\"#000000\" "
                             "fill-opacity=\"0.25\"/>"),
              std::string::npos);
    ImageIo images;
    const ImageFile image = rasterise(d, images, 2);
    double ink = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) ink += 1 - image.pixels[i] / 255;
    EXPECT_NEAR(ink / 4, 0.25 * 800, 1);
    EXPECT_NEAR(image.pixels[3 * (40 * 120 + 60)], 191, 1);
    // A loop that turns around a point twice paints it once; a triangle is half a rectangle.
    d.areas[0].points = {{10, 10}, {50, 10}, {50, 30}};
    const ImageFile half = rasterise(d, images, 2);
    double rest = 0;
    for (std::size_t i = 0; i < half.pixels.size(); i += 3) rest += 1 - half.pixels[i] / 255;
    EXPECT_NEAR(rest / 4, 0.25 * 400, 2);
}
