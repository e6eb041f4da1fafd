// SPDX-License-Identifier: Apache-2.0
// lobe features: what a scene's kernel contains, and the reason for each bit.
#include "cli.h"

using namespace lobe::test;

namespace {

// The feature's entry, or null.
nlohmann::json feature(const nlohmann::json& all, const std::string& name) {
    for (const auto& entry : all["features"])
        if (entry["name"] == name) return entry;
    return nullptr;
}

}  // namespace

TEST_F(Cli, FeaturesInWords) {
    const RunResult result = lobe({"features", "scene.pbrt"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    for (const char* line :
         {"in   TRIANGLES        shape at scene.pbrt:13:1\n",
          "in   SPHERES          shape at scene.pbrt:10:5\n",
          "in   SPHERE_LIGHTS    emitting shape at scene.pbrt:10:5\n",
          "out  TRIANGLE_LIGHTS  no triangle emits\n", "out  POINT_LIGHTS     no point light\n",
          "in   ENVIRONMENT      an infinite light\n",
          "out  THIN_LENS        the camera is a pinhole\n",
          "in   models           lambert rational\n"})
        EXPECT_NE(result.out.find(line), std::string::npos) << line << result.out;
}

TEST_F(Cli, FeaturesAsJson) {
    const auto json = nlohmann::json::parse(lobe({"features", "scene.pbrt", "--json", "-"}).out);
    EXPECT_EQ(json["brdfs"], nlohmann::json({"lambert", "rational"}));
    EXPECT_EQ(feature(json, "SPHERES")["in"], true);
    EXPECT_EQ(feature(json, "SPHERES")["reason"], "shape at scene.pbrt:10:5");
    EXPECT_EQ(feature(json, "THIN_LENS")["in"], false);
    for (const auto& entry : json["features"]) {
        EXPECT_NE(entry["reason"], "") << entry;
        EXPECT_NE(entry["meaning"], "") << entry;
    }
}

TEST_F(Cli, FeaturesFollowTheOptions) {
    const auto json = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"features", "scene.pbrt", "--json", "-"});
        return nlohmann::json::parse(lobe(words).out);
    };
    EXPECT_EQ(feature(json({}), "FILTER_TABLE")["in"], true);
    EXPECT_EQ(feature(json({"--filter", "box:0.5"}), "FILTER_TABLE")["in"], false);
    EXPECT_EQ(json({"--replace", "rational=phong"})["brdfs"], nlohmann::json({"lambert", "phong"}));
    const auto all = json({"--features", "all"});
    for (const auto& entry : all["features"]) EXPECT_EQ(entry["in"], true) << entry;
}

// What the render compiles in is what `lobe features` says.
TEST_F(Cli, TheRenderHasTheSameFeatures) {
    const auto told = nlohmann::json::parse(lobe({"features", "scene.pbrt", "--json", "-"}).out);
    const auto used = render({})["features"];
    EXPECT_EQ(used["brdfs"], told["brdfs"]);
    std::size_t in = 0;
    for (const auto& entry : told["features"]) in += entry["in"] == true;
    EXPECT_EQ(used["in"].size(), in);
    EXPECT_EQ(used["out"].size(), told["features"].size() - in);
    for (const auto& entry : used["in"])
        EXPECT_EQ(feature(told, entry["name"])["reason"], entry["reason"]);
}
