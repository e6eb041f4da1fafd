// SPDX-License-Identifier: Apache-2.0
// lobe paper: one small run gives every table, claim and file.
#include <cmath>

#include "base/files.h"
#include "cli.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class Paper : public Cli {
  protected:
    RunResult paper(std::vector<std::string> more = {}) const {
        std::vector<std::string> words = {"paper",           "scene.pbrt", "--resolution", "32x32",
                                          "--spp",           "4",          "--runs",       "2",
                                          "--reference-spp", "8",          "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        RunOptions options;
        options.environment = {{"XDG_CACHE_HOME", folder_.file("cache")}};
        return lobe(words, options);
    }
};

}  // namespace

TEST_F(Paper, SmallRunHasEverything) {
    const RunResult result =
        paper({"--json", "paper.json", "--csv", "paper.csv", "--html", "paper.html"});
    ASSERT_EQ(result.code, 0) << result.err;
    const auto json = nlohmann::json::parse(read_file(path("paper.json")));
    EXPECT_EQ(json["runs_complete"], 2);
    EXPECT_EQ(json["resolution"], nlohmann::json({32, 32}));
    EXPECT_EQ(json["stray_light_pixels"], 0);
    ASSERT_EQ(json["settings"].size(), 8u);
    double seconds = 0;
    for (const auto& setting : json["settings"]) {
        EXPECT_EQ(setting["parameters"][0]["material"], "rational");
        EXPECT_EQ(setting["reference_spp"], 8);
        ASSERT_EQ(setting["cells"].size(), 3u);
        for (const auto& cell : setting["cells"]) {
            ASSERT_EQ(cell["runs"].size(), 2u);
            EXPECT_GT(cell["absolute_error_255"], 0);
            seconds += cell["render_s"].get<double>();
        }
    }
    EXPECT_GT(seconds, 0);
    // Phong at equal albedo: the same n, ks times the ratio of K(100) 2 pi and 2 pi / 101.
    const auto& phong = json["settings"][3];
    EXPECT_EQ(phong["model"], "phong");
    EXPECT_EQ(phong["alike_in"], "albedo");
    EXPECT_EQ(phong["parameters"][0]["n"], 100);
    EXPECT_NEAR(phong["parameters"][0]["ks_per_sr"][0], 0.2 * 0.202368 / 0.0622098, 1e-4);
    // At equal half-width cos^m is half where c = n / (n + 1).
    const double m = std::log(0.5) / std::log(100 / 101.0);
    EXPECT_NEAR(json["settings"][6]["parameters"][0]["n"], m, 0.01);
    EXPECT_EQ(json["settings"][6]["model"], "modified_phong");
    EXPECT_NEAR(json["settings"][5]["parameters"][0]["n"], m + 1, 0.01);
    EXPECT_EQ(json["settings"][7]["alike_in"], "listing");
    EXPECT_EQ(json["ratios"].size(), 9u);
    EXPECT_EQ(json["paper"]["error_over_phong"], 0.4267);
    ASSERT_EQ(json["claims"].size(), 8u);
    EXPECT_EQ(json["claims"][5]["claim"], "listing_equals_formula");
    EXPECT_EQ(json["claims"][5]["verdict"], "DOES NOT HOLD");
    EXPECT_EQ(json["claims"][7]["verdict"], "UNDECIDED");  // of two runs
    const std::string csv = read_file(path("paper.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 8 * 3 * 2);
    const std::string html = read_file(path("paper.html"));
    EXPECT_NE(html.find("<html"), std::string::npos);
    EXPECT_NE(html.find("DOES NOT HOLD"), std::string::npos);
    EXPECT_NE(html.find("data:image/png"), std::string::npos);
    EXPECT_EQ(html.find("in turn\\n"), std::string::npos) << "lines of a terminal's text";
}

TEST_F(Paper, NeedsAMaterialToReplace) {
    write_scene(
        "Material \"rational\" \"rgb kd\" [.1 .02 .02] \"rgb ks\" [.2 .2 .2] \"float n\" [100]",
        "Material \"diffuse\"");
    const RunResult result = paper();
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("no material of the scene is plastic or rational"), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("--replace TYPE"), std::string::npos) << result.err;
}
