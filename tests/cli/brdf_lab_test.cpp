// SPDX-License-Identifier: Apache-2.0
// lobe brdf table, plot and doc: numbers, pictures and pages of models, a user's own among them.
#include <cmath>
#include <filesystem>

#include "base/files.h"
#include "cli.h"
#include "report/image_io.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class BrdfLab : public Cli {
  protected:
    RunResult brdf(std::vector<std::string> words, const RunOptions& options = {}) const {
        words.insert(words.begin(), "brdf");
        return lobe(words, options);
    }
    std::string made(std::vector<std::string> words, const std::string& file) const {
        words.insert(words.end(), {"--quiet", "-o", file});
        const RunResult result = brdf(words);
        EXPECT_EQ(result.code, 0) << joined(words) << "\n" << result.err;
        EXPECT_EQ(result.out + result.err, "");
        return result.code == 0 ? read_file(path(file)) : "";
    }
    nlohmann::json table(std::vector<std::string> words) const {
        words.insert(words.begin(), "table");
        words.insert(words.end(), {"--json", "-"});
        const RunResult result = brdf(words);
        EXPECT_EQ(result.code, 0) << result.err;
        return nlohmann::json::parse(result.out, nullptr, false);
    }
};

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
    return count;
}

}  // namespace

TEST_F(BrdfLab, TableTellsValuesAlbedoAndWidth) {
    const auto json = table(
        {"rational", "lambert", "--set", "rational.n=10", "--set", "kd=0.1", "--angles", "0,60"});
    ASSERT_EQ(json["models"].size(), 2u);
    const auto& rational = json["models"][0];
    EXPECT_EQ(rational["parameters"]["n"], 10);
    EXPECT_EQ(rational["light_deg"], nlohmann::json({-60, 0, 60}));
    const auto& view = rational["views"][1];
    EXPECT_EQ(view["view_deg"], 60);
    EXPECT_NEAR(view["peak_per_sr"], 0.35, 1e-6);
    EXPECT_NEAR(view["peak_light_deg"], 60, 1e-6);
    EXPECT_NEAR(view["half_width_below_deg"], std::acos(10 / 11.0) * 57.29577951, 2e-3);
    EXPECT_NEAR(view["f_per_sr"][0][2], 0.1, 1e-6);                     // towards the viewer
    EXPECT_NEAR(view["f_per_sr"][1][2], 0.1 + 0.25 * 0.5 / 5.5, 1e-6);  // c / (n - (n-1) c)
    // pi kd + 2 pi K(10) ks
    EXPECT_NEAR(rational["views"][0]["albedo"][0], 0.314159 + 0.25 * 0.859810, 2e-5);
    const auto& lambert = json["models"][1]["views"][1];
    EXPECT_TRUE(lambert["half_width_deg"].is_null());
    EXPECT_NEAR(lambert["albedo"][1], 0.314159, 2e-5);

    const RunResult text = brdf({"table", "rational", "--set", "n=10"});
    EXPECT_EQ(text.code, 0) << text.err;
    for (const char* part : {"rational with n 10", "half-width", "f in 1/sr"})
        EXPECT_NE(text.out.find(part), std::string::npos) << text.out;
}

TEST_F(BrdfLab, TableMatchesOneModelToAnother) {
    const auto json = table({"rational", "--match", "modified_phong", "--at", "10,100"});
    const auto& match = json["matches"][0];
    EXPECT_EQ(match["model"], "rational");
    EXPECT_EQ(match["parameter"], "n");
    EXPECT_EQ(match["to_model"], "modified_phong");
    ASSERT_EQ(match["matches"].size(), 2u);
    EXPECT_NEAR(match["matches"][0]["same_half_width"], 13.93, 0.005);
    EXPECT_NEAR(match["matches"][1]["same_lobe_integral"], 535.9, 0.05);
    EXPECT_NEAR(match["matches"][1]["same_normal_albedo"], 480.2, 0.05);
    expect_fault(brdf({"table", "lambert", "--match", "rational"}), 2,
                 "model 'lambert' has no parameter that shapes a lobe about the mirror direction",
                 "--kind curves");
    expect_fault(
        brdf({"table", "rational", "--match", "phong", "--vary", "kd"}), 2,
        "model 'phong' has no parameter 'kd' that shapes a lobe about the mirror direction",
        "--kind curves");
}

TEST_F(BrdfLab, PlotsAreSvgOrPng) {
    const std::string svg = made({"plot", "rational", "lambert", "--angles", "0,45"}, "a.svg");
    EXPECT_EQ(svg.substr(0, 5), "<svg ");
    for (const char* part : {">rational</text>", ">lambert</text>", ">45°</text>", "f in 1/sr"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    EXPECT_LT(svg.size(), 40000u);
    EXPECT_EQ(made({"plot", "rational", "lambert", "--angles", "0,45"}, "b.svg"), svg);
    made({"plot", "rational", "lambert", "--angles", "0,45"}, "a.png");
    const ImageFile image = ImageIo().read(path("a.png"));
    // Twice the pixels each way.
    EXPECT_NE(svg.find("width=\"" + std::to_string(image.width / 2) + "\""), std::string::npos);
    double dark = 0;
    for (const float value : image.pixels) dark += value < 128;
    EXPECT_GT(dark / static_cast<double>(image.pixels.size()), 0.002);
    EXPECT_LT(dark / static_cast<double>(image.pixels.size()), 0.1);
}

TEST_F(BrdfLab, CurvesAreThoseOfThePaperUnlessToldOtherwise) {
    const std::string svg = made({"plot", "--kind", "curves"}, "a.svg");
    for (const char* part :
         {">modified_phong</text>", ">rational</text>", ">by n; defaults</text>"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    for (const char* n : {">0.1</text>", ">10</text>", ">100</text>", ">1000</text>"})
        EXPECT_EQ(count_of(svg, n), 2u) << n;
    const std::string own =
        made({"plot", "rational", "--kind", "curves", "--at", "3,30", "--scale", "log"}, "a.svg");
    EXPECT_EQ(count_of(own, ">30</text>"), 1u);
    EXPECT_EQ(count_of(own, ">10⁻⁵</text>"), 1u);
}

TEST_F(BrdfLab, SpheresComeWithTheirError) {
    const RunResult result = brdf({"plot", "rational", "mirror", "--kind", "sphere", "--spp", "2",
                                   "-o", "s.png", "--json", "s.json"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(count_of(result.out, " %, 2 samples a pixel"), 2u) << result.out;
    const auto json = nlohmann::json::parse(read_file(path("s.json")));
    EXPECT_GT(json["models"][1]["relative_standard_error"], 0);
    const ImageFile image = ImageIo().read(path("s.png"));
    EXPECT_EQ(image.width, 12u + 2 * 332);
    expect_fault(brdf({"plot", "rational", "--kind", "sphere", "-o", "s.svg"}), 2,
                 "s.svg: a rendered sphere is no line drawing", "give -o FILE.png");
}

TEST_F(BrdfLab, WithoutAFontThePictureComesWithoutLabels) {
    RunOptions options;
    options.environment = {{"XDG_DATA_DIRS", "/nonexistent"}, {"XDG_DATA_HOME", "/nonexistent"}};
    const RunResult result = brdf({"plot", "lambert", "--quiet", "-o", "a.png"}, options);
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.err.find("warning: no font is found"), std::string::npos) << result.err;
    EXPECT_EQ(files(), "a.png scene.pbrt");
}

TEST_F(BrdfLab, DocIsAPageAModelAndAUsersOwnLikeAnyOther) {
    EXPECT_EQ(brdf({"new", "velvet", "--quiet"}).code, 0);
    const RunResult result = brdf({"doc", "rational", "velvet.cl", "--spp", "2", "-o", "pages/of"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "2 pages, pages/of/index.md\n");
    for (const char* name : {"rational", "velvet"})
        for (const char* kind : {".md", "-polar.svg", "-sphere.png"})
            EXPECT_TRUE(std::filesystem::exists(path("pages/of/") + name + kind)) << name << kind;
    const std::string page = read_file(path("pages/of/velvet.md"));
    for (const char* part :
         {"# velvet\n", "    f = kd + ks ((1 - cos theta_o) (1 - cos theta_i))^n", "**Source:** an",
          "`velvet.cl`", "| `n` | number | 4 | 1 to 1000 | how close the rim keeps",
          "![polar plot](velvet-polar.svg)", "The sphere: 2 samples a pixel, error ",
          "The model is claimed to be reciprocal, is claimed to conserve energy",
          "`lobe brdf check velvet --grid reduced`", "| reciprocity | ok |"})
        EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
    EXPECT_NE(read_file(path("pages/of/rational.md")).find("theta\\_o"), std::string::npos);
    const std::string index = read_file(path("pages/of/index.md"));
    EXPECT_NE(index.find("| [Rational Phong](rational.md) | f = kd + ks c"), std::string::npos);
    EXPECT_NE(index.find("| [velvet](velvet.md) |"), std::string::npos);
}

TEST_F(BrdfLab, DocTakesTheChecksOfAFile) {
    folder_.write("checks.json",
                  R"({"models": [{"model": "lambert", "checks": [
                      {"check": "energy", "verdict": "ok", "tests": 7, "worst": 0.25,
                       "limit": 0.5, "where": "kd 1"}]}]})");
    const std::vector<std::string> words = {"doc", "lambert", "--spp", "1", "--quiet", "-o", "."};
    std::vector<std::string> with = words;
    with.insert(with.end(), {"--checks", "checks.json"});
    ASSERT_EQ(brdf(with).code, 0);
    const std::string page = read_file(path("lambert.md"));
    EXPECT_NE(page.find("| energy | ok | worst 0.25 of 7, limit 0.5 (kd 1) |"), std::string::npos)
        << page;
    folder_.write("checks.json", "{\"models\": [{}]}");
    const RunResult result = brdf(with);
    EXPECT_EQ(result.code, 3);
    EXPECT_NE(result.err.find("lobe: error: checks.json: no results of checks"), std::string::npos);
}

TEST_F(BrdfLab, WhatCannotBeWrittenIsToldBeforeTheWork) {
    RunOptions no_device;
    no_device.environment = {{"OCL_ICD_VENDORS", "/nonexistent"}};
    expect_fault(brdf({"plot", "rational", "-o", "no/a.svg"}, no_device), 5,
                 "no/a.svg: cannot write a file in the folder no: No such file or directory",
                 "make the folder first");
    folder_.write("file", "");
    const RunResult doc = brdf({"doc", "rational", "-o", "file/pages"}, no_device);
    EXPECT_EQ(doc.code, 5);
    EXPECT_NE(doc.err.find("lobe: error: file/pages: the folder cannot be made"),
              std::string::npos);
    expect_fault(brdf({"plot", "rational", "-o", "a.jpg"}, no_device), 2,
                 "a.jpg: cannot write a plot of type '.jpg'", "plots end in .svg or .png");
    expect_fault(brdf({"plot", "rational", "-o", "a.exr"}, no_device), 2,
                 "a.exr: cannot write a plot of type '.exr'", "plots end in .svg or .png");
    expect_fault(brdf({"table"}, no_device), 2, "no model is named", "lobe brdf list");
    expect_fault(brdf({"table", "ratoinal"}, no_device), 2, "there is no model 'ratoinal'",
                 "did you mean 'rational'?");
    expect_fault(brdf({"table", "rational", "--set", "n=-1"}, no_device), 2,
                 "--set n=-1 is not understood", "n is a number from 0 to inf");
    EXPECT_EQ(files(), "file scene.pbrt");
}
