// SPDX-License-Identifier: Apache-2.0
// lobe features: what a scene's kernel contains, and the reason for each bit.
#include <filesystem>
#include <fstream>

#include "base/files.h"
#include "cli.h"

using namespace lobe::test;
namespace fs = std::filesystem;

namespace {

// The feature's entry, or null.
nlohmann::json feature(const nlohmann::json& all, const std::string& name) {
    for (const auto& entry : all["features"])
        if (entry["name"] == name) return entry;
    return nullptr;
}

// The smallest measurement of the scene.
std::vector<std::string> measure(std::vector<std::string> more) {
    std::vector<std::string> words = {"features", "scene.pbrt", "--measure", "--resolution",
                                      "16x16",    "--spp",      "2",         "--repeats",
                                      "2",        "--compiles", "1",         "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// Copies lobe's kernels to `folder`, with the first `old` of a file replaced.
void copy_kernels(const std::string& folder, const std::string& file, const std::string& old,
                  const std::string& fresh) {
    fs::copy(std::string(LOBE_SOURCE_DIR) + "/kernels", folder, fs::copy_options::recursive);
    std::string changed = lobe::read_file(folder + "/" + file);
    ASSERT_NE(changed.find(old), std::string::npos);
    changed.replace(changed.find(old), old.size(), fresh);
    std::ofstream(folder + "/" + file) << changed;
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

TEST_F(Cli, MeasuringCompilesInWhatIsLeftOut) {
    write_scene("WorldBegin", "WorldBegin LightSource \"point\" LightSource \"distant\"");
    RunOptions patient;
    patient.timeout = 110;
    const auto json = nlohmann::json::parse(lobe(measure({"--json", "-"}), patient).out);
    std::vector<std::string> left_out;
    for (const auto& entry : json["features"])
        if (entry["in"] == false) left_out.push_back(entry["name"]);
    ASSERT_FALSE(left_out.empty());
    left_out.insert(left_out.end(), {"all models", "everything"});
    const auto& measured = json["measured"];
    EXPECT_EQ(measured["resolution"], nlohmann::json({16, 16}));
    EXPECT_EQ(measured["image_hash"],
              hash({"--resolution", "16x16", "--spp", "2", "--seed", "1", "-o", "picture.exr"}));
    EXPECT_GT(measured["own"]["compile_cold_s"], 0.01);
    ASSERT_EQ(measured["more"].size(), left_out.size());
    for (std::size_t i = 0; i < left_out.size(); ++i) {
        const auto& kernel = measured["more"][i];
        EXPECT_EQ(kernel["name"], left_out[i]);
        EXPECT_GT(kernel["compile_cold_s"], 0.01);
        EXPECT_TRUE(kernel["compile_cold_s_deviation"].is_null());  // of one there is none
        EXPECT_GT(kernel["render_s"], 0);
        EXPECT_GT(kernel["render_ratio"], 0);
        EXPECT_LE(kernel["render_ratio_ci95"][0], kernel["render_ratio"]);
        EXPECT_LE(kernel["render_ratio"], kernel["render_ratio_ci95"][1]);
        EXPECT_EQ(kernel["verdict"], "not judged");
        EXPECT_EQ(kernel["not_judged_because"], "fewer than 6 repeats");
        EXPECT_EQ(kernel["device_bytes"], measured["own"]["device_bytes"]);
        for (const char* key : {"binary_bytes", "private_bytes"})
            EXPECT_TRUE(kernel[key].is_null() || kernel[key] > 0) << key;
    }
}

TEST_F(Cli, MeasuringNoticesAnotherPicture) {
    copy_kernels(path("kernels"), "path/camera.h", "*weight = frame->filter_weight;",
                 "*weight = LOBE_HAS_TRIANGLE_LIGHTS ? R(0.5) : frame->filter_weight;");
    expect_fault(
        lobe(measure({"--kernel-dir", "kernels", "--json", "-"})), 8,
        "scene.pbrt: with TRIANGLE_LIGHTS compiled in the picture differs from that of its own "
        "kernel: a fault of lobe");
}

TEST_F(Cli, MeasuringNeedsSomethingLeftOut) {
    expect_fault(lobe(measure({"--features", "all"})), 2,
                 "--measure has nothing to add to --features all");
}
