// SPDX-License-Identifier: Apache-2.0
// Line drawings: as SVG text, and as pixels whose ink is what geometry says.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "report/font.h"
#include "report/image_io.h"
#include "report/raster.h"
#include "report/svg.h"
#include "support/temp_folder.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr Ink black{0, 0, 0};

Drawing with(const Polyline& line) {
    Drawing drawing;
    drawing.width = drawing.height = 100;
    drawing.add(line);
    return drawing;
}

// Pixels as they look without any text, black counting one.
double ink_of(const Drawing& drawing, double scale) {
    ImageIo images;
    const ImageFile image = rasterise(drawing, images, scale);
    EXPECT_EQ(image.width, static_cast<std::uint32_t>(std::ceil(drawing.width * scale)));
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) sum += 1 - image.pixels[i] / 255;
    return sum;
}

}  // namespace

TEST(Drawing, SimplifyingKeepsWithinTheTolerance) {
    std::vector<glm::dvec2> arc;
    for (int k = 0; k <= 1000; ++k)
        arc.push_back(100.0 * glm::dvec2(std::cos(k * 3.1e-3), std::sin(k * 3.1e-3)));
    for (const double tolerance : {1.0, 0.1, 0.01}) {
        const std::vector<glm::dvec2> few = simplified(arc, tolerance);
        EXPECT_EQ(few.front(), arc.front());
        EXPECT_EQ(few.back(), arc.back());
        // An arc of angle t lies r (1 - cos t/2) off its chord.
        const double most_angle = 2 * std::acos(1 - tolerance / 100);
        EXPECT_LE(few.size(), 2 * 3.1 / most_angle + 2);
        for (const glm::dvec2& p : arc) {
            double nearest = 1e9;
            for (std::size_t i = 1; i < few.size(); ++i)
                nearest = std::min(nearest, distance_to_segment(p, few[i - 1], few[i]));
            EXPECT_LE(nearest, tolerance);
        }
    }
    EXPECT_EQ(simplified({{0, 0}, {1, 0}, {2, 0}}, 0.01).size(), 2u);
}

TEST(Svg, HoldsAllAndNeedsNothingElse) {
    Drawing drawing = with({{{1, 2}, {30.127, 40.5}, {99, 2}}, {17, 34, 255}, 1.5});
    drawing.title = "f < g & \"h\"";
    drawing.add(Dot{{50, 60}, 2.5, black});
    drawing.add(Text{{10, 20}, "30° <n>", black, 11, Anchor::end});
    const std::string svg = to_svg(drawing);
    for (const char* part :
         {"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\"",
          "<title>f &lt; g &amp; &quot;h&quot;</title>", "points=\"1,2 30.13,40.5 99,2\"",
          "stroke=\"#1122ff\" stroke-width=\"1.5\"",
          "<circle cx=\"50\" cy=\"60\" r=\"2.5\" fill=\"#000000\"/>", "text-anchor=\"end\"",
          ">30° &lt;n&gt;</text>"})
        EXPECT_NE(svg.find(part), std::string::npos) << part << "\n" << svg;
    EXPECT_EQ(svg.find("href"), std::string::npos);
    EXPECT_EQ(svg.find("script"), std::string::npos);
    EXPECT_EQ(svg.find("http", svg.find("http") + 1), std::string::npos);
    EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST(Raster, InkIsTheAreaOfTheShapes) {
    for (const double scale : {1.0, 2.0, 3.7}) {
        const double pixel = scale * scale;
        // A stroke has round ends.
        const double stroke = 60 * 3 + 3.14159 * 1.5 * 1.5;
        EXPECT_NEAR(ink_of(with({{{20, 50.3}, {80, 50.3}}, black, 3}), scale) / pixel, stroke, 2);
        EXPECT_NEAR(ink_of(with({{{20, 20}, {56, 68}}, black, 3}), scale) / pixel, stroke, 2);
        // A bend is inked once.
        EXPECT_NEAR(ink_of(with({{{20, 20}, {50, 20}, {20, 20}}, black, 3}), scale) / pixel,
                    30 * 3 + 7, 2);
        Drawing dot;
        dot.width = dot.height = 40;
        dot.add(Dot{{20.3, 19.8}, 10, black});
        EXPECT_NEAR(ink_of(dot, scale) / pixel, 3.14159 * 100, 3);
    }
}

TEST(Raster, WhatLeavesThePaperIsCut) {
    EXPECT_NEAR(ink_of(with({{{-500, 50}, {500, 50}}, black, 2}), 1), 200, 2);
    EXPECT_EQ(ink_of(with({{{-50, -50}, {-10, -20}}, black, 2}), 1), 0);
}

TEST(Raster, WithoutAFontThePictureComesWithAWarning) {
    ScopedVariable fonts("XDG_DATA_DIRS", "/nonexistent"), own("XDG_DATA_HOME", "/nonexistent");
    Drawing drawing = with({{{20, 50}, {80, 50}}, black, 3});
    drawing.add(Text{{10, 20}, "label", black});
    testing::internal::CaptureStderr();
    EXPECT_GT(ink_of(drawing, 1), 100);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("lobe: warning: no font is found"), std::string::npos) << said;
    EXPECT_NE(said.find("fonts-dejavu-core"), std::string::npos) << said;
}

TEST(Font, TheBestOneIsFoundWhereverItLies) {
    const TempFolder a, b;
    std::filesystem::create_directories(a.file("fonts/some/deep"));
    std::filesystem::create_directories(b.file("fonts"));
    a.write("fonts/FreeSans.ttf", "");
    const std::string both = a.path() + ":" + b.path();
    ScopedVariable own("XDG_DATA_HOME", "/nonexistent"), fonts("XDG_DATA_DIRS", both.c_str());
    EXPECT_EQ(find_font(), a.file("fonts/FreeSans.ttf"));
    b.write("fonts/unknown.ttf", "");
    EXPECT_EQ(find_font(), a.file("fonts/FreeSans.ttf"));
    b.write("fonts/DejaVuSans.ttf", "");
    EXPECT_EQ(find_font(), b.file("fonts/DejaVuSans.ttf"));
    a.write("fonts/some/deep/DejaVuSans.ttf", "");
    EXPECT_EQ(find_font(), a.file("fonts/some/deep/DejaVuSans.ttf"));
}
