// SPDX-License-Identifier: Apache-2.0
// Scenes by others, as their authors wrote them: LOBE_TEST_SCENES names the folder.
#include <cstdlib>
#include <filesystem>
#include <map>

#include "cli.h"

using namespace lobe::test;

namespace {

class ForeignScenes : public Cli {
  protected:
    // The path of a scene, or "" after the reason to skip has been told.
    static std::string scene(const std::string& name) {
        const char* folder = std::getenv("LOBE_TEST_SCENES");
        if (!folder || !*folder) return "";
        const std::string path = std::string(folder) + "/" + name;
        EXPECT_TRUE(std::filesystem::exists(path)) << path;
        return path;
    }

    // A small picture that must be sound; its results.
    nlohmann::json small(const std::string& path, const std::vector<std::string>& more) const {
        std::vector<std::string> words{path, "-o", "out.exr"};
        words.insert(words.end(), more.begin(), more.end());
        const auto json = render(words);
        EXPECT_EQ(json["nonfinite"], 0) << joined(words);
        EXPECT_EQ(json["negative"], 0) << joined(words);
        EXPECT_GT(double(json["error"]["mean"]), 0.0) << joined(words);
        return json;
    }
};

}  // namespace

#define LOBE_FOREIGN_SCENE(path, name)    \
    const std::string path = scene(name); \
    if (path.empty()) GTEST_SKIP() << "LOBE_TEST_SCENES is not set: " << name

TEST_F(ForeignScenes, TheSameBoxInBothDialects) {
    LOBE_FOREIGN_SCENE(v3, "cornell-box/scene-v3.pbrt");
    const std::string v4 = scene("cornell-box/scene-v4.pbrt");
    const std::vector<std::string> alike{"--resolution", "64x64",   "--max-depth", "5",
                                         "--filter",     "box:0.5", "--spp",       "8",
                                         "--seed",       "1"};
    const auto a = small(v3, alike), b = small(v4, alike);
    EXPECT_EQ(a["dialect"], "v3");
    EXPECT_EQ(b["dialect"], "v4");
    EXPECT_EQ(a["image_hash"], b["image_hash"]);
    EXPECT_NE(a["scene_hash"], b["scene_hash"]);
    EXPECT_EQ(a["triangles"], b["triangles"]);
}

TEST_F(ForeignScenes, Killeroo) {
    LOBE_FOREIGN_SCENE(path, "killeroo/killeroo-simple.pbrt");
    const std::vector<std::string> size{"--resolution", "48x48", "--spp", "4"};
    const auto json = small(path, size);
    EXPECT_EQ(json["triangles"], 2 * 33264 + 4);
    EXPECT_EQ(json["features"]["brdfs"], nlohmann::json({"lambert", "plastic"}));
    for (const char* model : {"rational", "phong", "modifiedphong"}) {
        std::vector<std::string> words = size;
        words.insert(words.end(), {"--replace", std::string("plastic=") + model});
        const auto sharp = small(path, words);
        EXPECT_NE(sharp["image_hash"], json["image_hash"]) << model;
        words.insert(words.end(), {"--n", "10"});
        EXPECT_NE(small(path, words)["image_hash"], sharp["image_hash"]) << model;
    }
}

// Mean luminance of pixels [140, 595) x [300, 600) of the 700x700 picture, from an independent path
// tracer (own geometry, sampling and models over Mitsuba 3's ray casting; 128 to 512 samples a
// pixel). The models lie up to 3 % apart here, so each is known from the others.
TEST_F(ForeignScenes, KillerooIsAsBrightAsAnotherRendererSays) {
    LOBE_FOREIGN_SCENE(path, "killeroo/killeroo-simple.pbrt");
    const std::map<std::string, double> known{
        {"rational", 0.146841}, {"phong", 0.143540}, {"modifiedphong", 0.143021}};
    for (const auto& [model, mean] : known) {
        const auto json = small(path, {"--replace", "plastic=" + model, "--spp", "4", "--crop",
                                       "0.2,0.85,0.428571,0.857142"});
        EXPECT_NEAR(double(json["error"]["image_mean"]), mean, 0.005 * mean) << model;
    }
}

TEST_F(ForeignScenes, VeachMis) {
    LOBE_FOREIGN_SCENE(path, "veach-mis/scene-v4.pbrt");
    EXPECT_EQ(small(path, {"--resolution", "64x36", "--spp", "4"})["features"]["brdfs"],
              nlohmann::json({"conductor", "lambert"}));
}
