// SPDX-License-Identifier: Apache-2.0
// What a render writes: pictures with their error and their story, and results as JSON.
#include <algorithm>
#include <cmath>

#include "cli.h"
#include "report/image_io.h"

using namespace lobe;
using namespace lobe::test;

namespace {

bool has_channel(const ImageFile& image, const std::string& name) {
    return std::count(image.channels.begin(), image.channels.end(), name) == 1;
}

std::string text_of(const ImageFile& image, const std::string& name) {
    const auto found = image.attributes.find(name);
    return found == image.attributes.end() ? "absent" : std::get<std::string>(found->second);
}

double sum_of(const ImageFile& image, const std::string& channel) {
    const auto at = std::find(image.channels.begin(), image.channels.end(), channel);
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(at - image.channels.begin());
         i < image.pixels.size(); i += image.channels.size())
        sum += image.pixels[i];
    return sum;
}

}  // namespace

TEST_F(Cli, ExrHoldsThePictureItsErrorAndItsStory) {
    const auto json = render({"-o", "out.exr", "--seed", "5"});
    const ImageFile image = ImageIo().read(path("out.exr"));
    EXPECT_EQ(image.width, 32u);
    EXPECT_EQ(image.height, 24u);
    EXPECT_EQ(image.full_width, 32u);
    EXPECT_EQ(image.channels.size(), 6u);
    for (const char* name : {"R", "G", "B", "StdError.R", "StdError.G", "StdError.B"})
        EXPECT_TRUE(has_channel(image, name)) << name;
    EXPECT_GT(sum_of(image, "R"), 0.0);
    EXPECT_GT(sum_of(image, "StdError.R"), 0.0);
    EXPECT_LT(sum_of(image, "StdError.R"), sum_of(image, "R"));
    EXPECT_TRUE(std::isfinite(sum_of(image, "StdError.B")));

    EXPECT_EQ(text_of(image, "samplesPerPixel"), "4");
    EXPECT_GT(std::stod(text_of(image, "renderTimeSeconds")), 0.0);
    EXPECT_EQ(text_of(image, "lobe:seed"), "5");
    EXPECT_EQ(text_of(image, "lobe:sampleRange"), "0:4");
    EXPECT_EQ(text_of(image, "lobe:sceneHash"), json["scene_hash"]);
    EXPECT_EQ(text_of(image, "lobe:imageHash"), json["image_hash"]);
    EXPECT_EQ(text_of(image, "lobe:nonfinite"), "0");
    EXPECT_EQ(text_of(image, "lobe:partial"), "0");
    EXPECT_NE(text_of(image, "lobe:device").find(std::string(json["device"])), std::string::npos);
    EXPECT_NE(text_of(image, "lobe:commandLine").find("--seed 5"), std::string::npos);
    EXPECT_NEAR(std::stod(text_of(image, "lobe:relativeStandardError")),
                double(json["error"]["relative_standard_error"]), 1e-5);
    EXPECT_EQ(text_of(image, "lobe:version"), json["lobe"]);
}

TEST_F(Cli, OneSampleTellsNothingOfItsError) {
    const RunResult result =
        lobe({"render", "scene.pbrt", "--spp", "1", "-o", "out.exr", "--json", "out.json"});
    ASSERT_EQ(result.code, 0);
    EXPECT_NE(result.out.find("error    unknown "), std::string::npos) << result.out;
    const ImageFile image = ImageIo().read(path("out.exr"));
    EXPECT_EQ(image.channels.size(), 3u);
    EXPECT_EQ(text_of(image, "lobe:relativeStandardError"), "absent");
    const auto json =
        nlohmann::json::parse(lobe({"render", "scene.pbrt", "--spp", "1", "--json", "-"}).out);
    EXPECT_TRUE(json["error"]["relative_standard_error"].is_null());
    EXPECT_TRUE(json["error"]["mean_ci95"].is_null());
    EXPECT_EQ(json["error"]["replicates"], 1);
    EXPECT_EQ(files(), "lobe.exr out.exr out.json scene.pbrt");
}

TEST_F(Cli, PngIsTheSamePictureInSrgb) {
    render({"-o", "out.exr", "-o", "out.PNG", "-o", "bright.png"});
    const ImageFile light = ImageIo().read(path("out.exr")),
                    bytes = ImageIo().read(path("out.PNG"));
    ASSERT_TRUE(bytes.bytes);
    ASSERT_EQ(bytes.channels.size(), 3u);
    ASSERT_EQ(bytes.pixels.size(), 32u * 24 * 3);
    double worst = 0;
    for (std::size_t p = 0; p < 32 * 24; ++p)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto at =
                std::find(light.channels.begin(), light.channels.end(), std::string(1, "RGB"[c]));
            const double v = light.pixels[6 * p + std::size_t(at - light.channels.begin())];
            const double srgb = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
            const double wanted = 255 * std::min(std::max(srgb, 0.0), 1.0);
            worst = std::max(worst, std::fabs(bytes.pixels[3 * p + c] - wanted));
        }
    EXPECT_LE(worst, 0.501);
}

TEST_F(Cli, ExposureIsAFactorOfPngOnly) {
    const std::string plain = hash({"-o", "a.exr", "-o", "a.png"});
    EXPECT_EQ(hash({"-o", "b.exr", "-o", "b.png", "--exposure", "2"}), plain);
    EXPECT_GT(sum_of(ImageIo().read(path("b.png")), "R"),
              1.2 * sum_of(ImageIo().read(path("a.png")), "R"));
}

// The crop is a window of the same film: its pixels are the ones the whole picture has.
TEST_F(Cli, CropIsAWindow) {
    render({"-o", "whole.exr"});
    const auto json = render({"-o", "part.exr", "--crop", "0.25,0.75,0.5,1"});
    EXPECT_EQ(json["resolution"], nlohmann::json({16, 12}));
    const ImageFile whole = ImageIo().read(path("whole.exr")),
                    part = ImageIo().read(path("part.exr"));
    EXPECT_EQ(part.x, 8u);
    EXPECT_EQ(part.y, 12u);
    EXPECT_EQ(part.width, 16u);
    EXPECT_EQ(part.height, 12u);
    EXPECT_EQ(part.full_width, 32u);
    EXPECT_EQ(part.full_height, 24u);
    const std::size_t row = 16 * part.channels.size();
    for (std::size_t y = 0; y < 12; ++y)
        EXPECT_TRUE(std::equal(&part.pixels[y * row], &part.pixels[y * row] + row,
                               &whole.pixels[((12 + y) * 32 + 8) * whole.channels.size()]))
            << "row " << y;
}

TEST_F(Cli, ResultsAsJson) {
    const auto json = render({"-o", "out.png"});
    for (const char* key :
         {"scene", "scene_hash", "device", "driver", "seed", "spp", "resolution", "seconds",
          "samples_per_s", "error", "features", "nonfinite", "outputs", "partial", "image_hash"})
        EXPECT_TRUE(json.contains(key)) << key;
    for (const char* step : {"parse", "bvh", "compile", "upload", "render", "write", "total"}) {
        const std::string key = step;
        ASSERT_TRUE(json["seconds"].contains(key)) << key;
        EXPECT_GE(double(json["seconds"][key]), 0.0);
        EXPECT_LE(double(json["seconds"][key]), double(json["seconds"]["total"]));
    }
    for (const char* key : {"relative_standard_error", "mean", "mean_ci95", "replicates"})
        EXPECT_TRUE(json["error"].contains(key)) << key;
    EXPECT_EQ(json["spp"], 4);
    EXPECT_EQ(json["seed"], 0);
    EXPECT_EQ(json["nonfinite"], 0);
    EXPECT_EQ(json["partial"], false);
    EXPECT_EQ(json["resolution"], nlohmann::json({32, 24}));
    EXPECT_EQ(json["outputs"], nlohmann::json({"out.png"}));
    EXPECT_EQ(json["features"]["brdfs"], nlohmann::json({"lambert", "rational"}));
    EXPECT_EQ(json["features"]["in"].size(), 3u);
    EXPECT_GT(json["features"]["out"].size(), 2u);
    EXPECT_EQ(std::string(json["image_hash"]).size(), 64u);
    const double mean = json["error"]["mean"];
    EXPECT_LT(double(json["error"]["mean_ci95"][0]), mean);
    EXPECT_GT(double(json["error"]["mean_ci95"][1]), mean);
}
