// SPDX-License-Identifier: Apache-2.0
// What a render is asked to reach: an error, a time, a number of samples.
#include <algorithm>

#include "base/files.h"
#include "cli.h"
#include "report/image_io.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class Goals : public Cli {};

}  // namespace

TEST_F(Goals, AnErrorIsReached) {
    const auto json = render({"-o", "out.exr", "--error", "20%"});
    EXPECT_EQ(json["end"]["by"], "error");
    EXPECT_DOUBLE_EQ(json["end"]["error_target"], 0.2);
    EXPECT_LE(json["end"]["error_bound95"], 0.2);
    EXPECT_LE(json["error"]["relative_standard_error"], 0.2);
    EXPECT_GE(json["spp"], 8);
    const auto finer = render({"-o", "out.exr", "--error", "0.01"});
    EXPECT_GT(finer["spp"], json["spp"]) << "the scene's 4 samples are no ceiling";
    EXPECT_LE(finer["error"]["relative_standard_error"], 0.01);
}

TEST_F(Goals, SamplesAreTheCeiling) {
    const RunResult result =
        lobe({"render", "scene.pbrt", "-o", "out.exr", "--error", "0.01%", "--spp", "12"});
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.out.find("0.01 % was not reached: ended by the ceiling of --spp"),
              std::string::npos)
        << result.out;
    const auto json = render({"-o", "out.exr", "--error", "0.01%", "--spp", "12"});
    EXPECT_EQ(json["end"]["by"], "samples");
    EXPECT_EQ(json["spp"], 12);
}

TEST_F(Goals, TheLastLineTellsTheWayOn) {
    const RunResult result = lobe({"render", "scene.pbrt", "-o", "out.exr", "--spp", "64"});
    const std::size_t line = result.out.find("way on   error ");
    ASSERT_NE(line, std::string::npos) << result.out;
    EXPECT_EQ(result.out.find('\n', line), result.out.size() - 1) << "it is the last";
    EXPECT_NE(result.out.find(" render scene.pbrt -o out.exr --error ", line), std::string::npos);
    EXPECT_EQ(result.out.find("--spp", line), std::string::npos);
}

TEST_F(Goals, TimeIsUsed) {
    const auto json = render({"-o", "out.exr", "--time", "1.5", "--resolution", "320x240"});
    EXPECT_EQ(json["end"]["by"], "time");
    EXPECT_EQ(json["end"]["time_target_s"], 1.5);
    EXPECT_GE(json["spp"], 1);
    EXPECT_EQ(json["partial"], false);
}

TEST_F(Goals, AdaptiveTellsItsPilot) {
    const auto json =
        render({"-o", "out.exr", "--adaptive", "--spp", "32", "--resolution", "160x120"});
    EXPECT_EQ(json["end"]["adaptive"]["pilot_spp"], 8);
    EXPECT_NEAR(json["spp"], 32, 8);
    const auto again =
        render({"-o", "out.exr", "--adaptive", "--spp", "32", "--resolution", "160x120"});
    EXPECT_EQ(json["image_hash"], again["image_hash"]);
    const auto channels = ImageIo().read(path("out.exr")).channels;
    EXPECT_EQ(std::count(channels.begin(), channels.end(), "SampleCount"), 1);
    EXPECT_NE(json["image_hash"],
              hash({"-o", "out.exr", "--spp", "32", "--resolution", "160x120"}));
}

TEST_F(Goals, APageNeedsNothingBesideIt) {
    render({"-o", "out.exr", "--html", "out.html"});
    const std::string page = read_file(path("out.html"));
    EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u) << page.substr(0, 40);
    EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
    EXPECT_EQ(page.find("src=\"http"), std::string::npos);
    EXPECT_EQ(lobe({"render", "scene.pbrt", "--html", "no/out.html"}).code, 5);
}

TEST_F(Goals, NonsenseIsRefused) {
    for (const std::string text : {"0", "-1%", "101%", "1.5", "x", "%", "nan", ""}) {
        const RunResult result = lobe({"render", "scene.pbrt", "--error", text});
        EXPECT_EQ(result.code, 2) << text;
        EXPECT_NE(result.err.find("--error"), std::string::npos) << result.err;
    }
    EXPECT_EQ(lobe({"render", "scene.pbrt", "--time", "0"}).code, 2);
    EXPECT_EQ(files(), "scene.pbrt");
}
