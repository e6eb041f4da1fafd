// SPDX-License-Identifier: Apache-2.0
// The page as text: all escaped, nothing from outside, pictures and tables that decode to what was
// given. How it behaves in a browser is for tools/checks/browser.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/files.h"
#include "report/chart/line_chart.h"
#include "report/html/base64.h"
#include "report/html/costs.h"
#include "report/html/parts.h"
#include "report/html/pictures.h"
#include "report/html/render_page.h"
#include "report/html/report_page.h"
#include "report/html/rgbe.h"
#include "report/image_io.h"
#include "report/markup.h"
#include "support/temp_folder.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const std::string odd = "a<b>&\"c'\x01\xff";
const std::string odd_escaped = "a&lt;b&gt;&amp;&quot;c&#39;\\x01\\xff";

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

std::string from_base64(const std::string& text) {
    static const std::string digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    unsigned group = 0, bits = 0;
    for (const char c : text) {
        const std::size_t value = digits.find(c);
        if (value == std::string::npos) break;
        group = group << 6 | static_cast<unsigned>(value);
        bits += 6;
        if (bits >= 8) out += static_cast<char>(group >> (bits -= 8) & 255);
    }
    return out;
}

// What stands between `before` and the next quote.
std::string quoted(const std::string& text, const std::string& before) {
    const std::size_t at = text.find(before);
    if (at == std::string::npos) return "";
    return text.substr(at + before.size(), text.find('"', at + before.size()) - at - before.size());
}

ImageFile picture(std::uint32_t width, std::uint32_t height, float value) {
    ImageFile file;
    file.width = file.full_width = width;
    file.height = file.full_height = height;
    file.channels = {"R", "G", "B"};
    file.pixels.assign(3 * std::size_t(width) * height, value);
    return file;
}

ReportPage sample_page() {
    ReportPage page;
    page.title = "T " + odd;
    page.headline = "H " + odd;
    page.table = {"Table " + odd, {"name " + odd, "x"}, {{odd, "1"}, {"b", "-2.5 %"}}, {}, odd};
    ReportSection section;
    section.heading = "S " + odd;
    section.paragraphs = {"P " + odd};
    section.facts = {{"F " + odd, odd}};
    LineChart chart{odd, odd, odd, {{odd, {{1, 1}, {2, 0.5}}, {}}}, true, true, -0.5, {}};
    section.figures.push_back({draw(chart), "C " + odd});
    section.viewers.push_back({"V " + odd, {{"N " + odd, picture(8, 4, 0.25f), odd}}, 2});
    page.sections = {section, section};
    page.environment.device.name = odd;
    page.environment.command = {"lobe", "render", "</script><script>alert(1)</script>"};
    page.environment.kernels = {{odd, all_features(), {odd}}};
    return page;
}

}  // namespace

TEST(Html, Base64KnowsItsVectors) {  // RFC 4648, section 10
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Html, EveryTextIsEscaped) {
    ImageIo images;
    const std::string html = to_html(sample_page(), images);
    EXPECT_EQ(html.find("a<b>"), std::string::npos);
    EXPECT_EQ(html.find('\x01'), std::string::npos);
    EXPECT_EQ(html.find('\xff'), std::string::npos);
    for (const char* mark : {"T ", "H ", "S ", "P ", "F ", "C ", "V ", "N ", "Table "})
        EXPECT_NE(html.find(mark + odd_escaped), std::string::npos) << mark;
    EXPECT_EQ(count(html, "<script>"), 1u);
    EXPECT_EQ(count(html, "</script>"), 1u);
}

TEST(Html, NothingComesFromOutside) {
    ImageIo images;
    std::string html = to_html(sample_page(), images);
    EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
    for (std::size_t at; (at = html.find("xmlns=\"http://www.w3.org/2000/svg\"")) != html.npos;)
        html.erase(at, 34);
    for (const char* part : {"http:", "https:", "//cdn", "url(", "@import", "fetch(", "XMLHttp"})
        EXPECT_EQ(html.find(part), std::string::npos) << part;
    EXPECT_EQ(count(html, "src=\""), count(html, "src=\"data:image/png;base64,"));
    EXPECT_EQ(count(html, "href=\""),
              count(html, "href=\"data:") + count(html, "href=\"#section") + 1);
}

TEST(Html, ATableComesAlongAsCsv) {
    ReportTable table{"Equal time, A/B", {"name", "x"}, {{"a,b", "1"}, {"say \"q\"", "2"}}, {}, ""};
    EXPECT_EQ(csv_of(table), "name,x\r\n\"a,b\",1\r\n\"say \"\"q\"\"\",2\r\n");
    const std::string html = table_html(table);
    EXPECT_EQ(from_base64(quoted(html, "data:text/csv;charset=utf-8;base64,")), csv_of(table));
    EXPECT_NE(html.find("download=\"equal-time-a-b.csv\""), std::string::npos);
    EXPECT_NE(html.find("<td class=\"number\">1</td>"), std::string::npos);
    EXPECT_NE(html.find("<td>a,b</td>"), std::string::npos);
    table.csv = {{"x_s"}, {"1.25"}};
    EXPECT_EQ(csv_of(table), "x_s\r\n1.25\r\n");
    EXPECT_EQ(table_html({}), "");
}

TEST(Html, SharedExponentsKeepLinearLight) {
    const auto back = [](const std::array<std::uint8_t, 4>& e, int c) {
        return std::ldexp(1.0 * e[static_cast<std::size_t>(c)], e[3] - 136);
    };
    for (double v = 1e-30; v < 1e30; v *= 1.37) {
        const float rgb[3] = {static_cast<float>(v), static_cast<float>(0.5 * v), 0};
        const auto e = rgbe(rgb);
        EXPECT_NEAR(back(e, 0), v, v / 256) << v;
        EXPECT_NEAR(back(e, 1), 0.5 * v, v / 256) << v;
        EXPECT_EQ(e[2], 0);
    }
    const float largest = std::numeric_limits<float>::max();
    for (const float value : {-1.0f, std::nanf(""), 0.0f, 1e-44f}) {
        const float rgb[3] = {value, value, value};
        EXPECT_EQ(back(rgbe(rgb), 0), 0) << value;
    }
    for (const float value : {largest, std::numeric_limits<float>::infinity()}) {
        const float rgb[3] = {value, 1, value};
        EXPECT_GE(back(rgbe(rgb), 0), 1e38) << value;
        EXPECT_EQ(rgbe(rgb)[3], 255) << value;
    }
    const float edge[3] = {0.9999f, 0, 0};  // rounds to the next power of two
    EXPECT_NEAR(back(rgbe(edge), 0), 1, 1e-3);
}

TEST(Html, AViewerHoldsThePictureTwice) {
    ImageIo images;
    ImageFile light = picture(8, 4, 0.25f);
    light.pixels[3 * 9] = 4;
    ImageFile map = picture(8, 4, 200);
    map.bytes = true;
    const std::string html =
        viewer_html({"caption", {{"light", light, ""}, {"map", map, "a scale"}}, 2}, images);
    EXPECT_NE(html.find("data-stops=\"1.000000\""), std::string::npos);
    EXPECT_EQ(count(html, "data-linear"), 1u);
    EXPECT_NE(html.find("a scale"), std::string::npos);
    const std::string linear = from_base64(quoted(html, "data-linear=\""));
    ASSERT_EQ(linear.size(), 4u * 32);
    EXPECT_EQ(linear.substr(0, 4), "\x80\x80\x80\x7f");
    EXPECT_EQ(linear.substr(36, 4), std::string("\x80\x08\x08\x83"));
    const TempFolder folder;
    folder.write("a.png", from_base64(quoted(html, "src=\"data:image/png;base64,")));
    const ImageFile back = images.read(folder.file("a.png"));
    EXPECT_EQ(back.width, 8u);
    EXPECT_EQ(back.pixels[0], 188);  // sRGB of 2 * 0.25
    EXPECT_EQ(back.pixels[27], 255);
    EXPECT_EQ(viewer_html({}, images), "");
    EXPECT_THROW(viewer_html({"", {{"a", light, ""}, {"b", picture(8, 5, 1), ""}}, 1}, images),
                 Error);
    light.channels = {"X", "Y", "Z"};
    EXPECT_THROW(viewer_html({"", {{"a", light, ""}}, 1}, images), Error);
}

TEST(Html, MapsAreWhatTheySay) {
    const std::vector<float> a = {1, 1, 1, 1, 1, 1, 0, 0, 0}, b = {1, 1, 1, 2, 2, 2, 1, 1, 1},
                             error(9, 0.25f), none(9, 0.0f);
    const PictureView x{3, 1, &a, &error, nullptr}, y{3, 1, &b, &none, nullptr};
    const ImageFile z = z_picture("z", x, y).image;
    EXPECT_TRUE(z.bytes);
    EXPECT_EQ(z.pixels[0], 255);          // equal: white
    EXPECT_LT(z.pixels[3], z.pixels[5]);  // darker: blue
    EXPECT_EQ((std::vector<float>(z.pixels.begin() + 3, z.pixels.begin() + 6)),
              (std::vector<float>{33, 80, 170}));  // z = -4
    const ImageFile turned = z_picture("z", y, x).image;
    EXPECT_GT(turned.pixels[3], turned.pixels[5]);
    EXPECT_EQ(error_picture("e", x, x).image.pixels, std::vector<float>(9, 0.0f));
    EXPECT_NE(standard_error_picture("s", x).image.pixels, std::vector<float>(9, 0.0f));
    EXPECT_EQ(linear_picture("l", x).image.pixels, a);
    const ImageFile part = cropped(linear_picture("l", x).image, 1, 0, 5, 1);
    EXPECT_EQ(part.width, 2u);
    EXPECT_EQ(part.pixels, (std::vector<float>{1, 1, 1, 0, 0, 0}));
}

TEST(Html, CostsAreSaidTwice) {
    RenderTimes times;
    times.parse = 0.125;
    times.render = 2.5;
    times.total = 2.625;
    const ReportSection section = cost_section({{"cold", times}});
    ASSERT_EQ(section.figures.size(), 1u);
    ASSERT_EQ(section.tables.size(), 1u);
    EXPECT_EQ(section.tables[0].csv[1],
              (std::vector<std::string>{"cold", "0.125", "0", "0", "0", "2.5", "0", "2.625"}));
}

TEST(Html, ARenderIsAPage) {
    RenderReport report;
    report.scene = "scenes/a<b.pbrt";
    report.width = 800;
    report.height = 2;
    report.command = {"lobe", "render", "scenes/a<b.pbrt"};
    report.features = all_features();
    Estimate& picture = report.picture;
    picture.width = 800;
    picture.height = 2;
    picture.rgb.assign(3 * 1600, 0.5f);
    picture.mean_samples = 8;
    ImageIo images;
    const std::string unknown = render_page(report, images);
    EXPECT_EQ(count(unknown, "<img"), 1u);
    EXPECT_NE(unknown.find("relative standard error is unknown"), std::string::npos);
    EXPECT_NE(unknown.find("shown is the middle, 700 by 2"), std::string::npos);
    picture.standard_error.assign(3 * 1600, 0.1f);
    picture.relative_standard_error = 0.2;
    report.seconds.render = 3;
    const std::string known = render_page(report, images);
    EXPECT_EQ(count(known, "<img"), 2u);
    for (const char* words : {"Render of a&lt;b.pbrt", "20 %", "10 % needs about", "--error 10%",
                              "Where the time goes", "What the kernel holds"})
        EXPECT_NE(known.find(words), std::string::npos) << words;
}
