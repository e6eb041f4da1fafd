// SPDX-License-Identifier: Apache-2.0
// The same seed gives the same bits, however the picture is made.
#include <filesystem>

#include "base/files.h"
#include "cli.h"

using namespace lobe::test;
namespace fs = std::filesystem;

namespace {

RunOptions threads(const std::string& count) {
    RunOptions options;
    options.environment = {{"POCL_MAX_PTHREAD_COUNT", count}};
    return options;
}

}  // namespace

TEST_F(Cli, TheHashIsThePictures) {
    const std::string plain = hash({});
    EXPECT_EQ(plain.size(), 64u);
    EXPECT_EQ(hash({}), plain);
    EXPECT_EQ(hash({"-o", "a.exr", "-o", "b.png", "--exposure", "3"}), plain);
    EXPECT_EQ(hash({}, threads("1")), plain);
    EXPECT_EQ(hash({}, threads("2")), plain);
    EXPECT_EQ(hash({"--seed", "0", "--spp", "004"}), plain);
    EXPECT_NE(hash({"--seed", "1"}), plain);
    EXPECT_NE(hash({"--seed", "4294967296"}), plain);
    EXPECT_NE(hash({"--spp", "5"}), plain);
}

TEST_F(Cli, TheGeneralKernelGivesTheSameBits) { EXPECT_EQ(hash({"--features", "all"}), hash({})); }

TEST_F(Cli, KernelsFromAFolderGiveTheSameBits) {
    const std::string plain = hash({});
    EXPECT_EQ(hash({"--kernel-dir", LOBE_SOURCE_DIR "/kernels"}), plain);
    RunOptions elsewhere;
    elsewhere.folder = "/";
    EXPECT_EQ(hash({path("scene.pbrt"), "-o", path("x.png")}, elsewhere), plain);
}

// Changing a kernel changes the picture without a rebuild.
TEST_F(Cli, AnEditedKernelIsTheOneThatRuns) {
    fs::copy(LOBE_SOURCE_DIR "/kernels", path("kernels"), fs::copy_options::recursive);
    const std::string plain = hash({});
    const fs::path lambert = path("kernels/brdf/lambert.h");
    std::string text = lobe::read_file(lambert.string());
    const std::string from = "return m->kd * wi.z;", to = "return m->kd * (wi.z * wi.z);";
    ASSERT_NE(text.find(from), std::string::npos);
    folder_.write("kernels/brdf/lambert.h", text.replace(text.find(from), from.size(), to));
    EXPECT_NE(hash({"--kernel-dir", "kernels"}), plain);
}

TEST_F(Cli, TheSceneHashIsTheTexts) {
    const auto plain = render({})["scene_hash"];
    EXPECT_EQ(render({"--seed", "3", "--spp", "1"})["scene_hash"], plain);
    write_scene("[100]", "[101]");
    EXPECT_NE(render({})["scene_hash"], plain);
}
