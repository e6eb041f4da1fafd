// SPDX-License-Identifier: Apache-2.0
// A render that is stopped writes what there is, at once.
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "base/files.h"
#include "cli.h"
#include "report/image_io.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class Stopped : public Cli {
  protected:
    // Stops a render that would take hours once it is under way, and gives its end.
    RunResult stop(const std::string& resolution, int signal) {
        RunOptions options;
        options.folder = folder_.path();
        options.terminal = true;  // for the bar, which tells how far rendering is
        options.environment = {{"TERM", "xterm"}};
        Process process({LOBE_PROGRAM, "render", "scene.pbrt", "-o", "out.exr", "--json",
                         "out.json", "--spp", "1000000", "--resolution", resolution},
                        options);
        // The first bar may come amid the first block, which is then cut short.
        EXPECT_TRUE(process.wait_for_stderr("samples/s", 3));
        const auto begin = std::chrono::steady_clock::now();
        process.kill(signal);
        const RunResult result = process.wait();
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return result;
    }

    std::string attribute(const std::string& name) {
        return std::get<std::string>(ImageIo().read(path("out.exr")).attributes.at(name));
    }

    double seconds_ = 0;
};

}  // namespace

TEST_F(Stopped, InterruptWritesThePictureSoFar) {
    const RunResult result = stop("32x24", SIGINT);
    EXPECT_EQ(result.code, 130);
    EXPECT_LT(seconds_, 2);
    const auto json = nlohmann::json::parse(read_file(path("out.json")));
    EXPECT_EQ(json["partial"], true);
    const std::uint64_t spp = json["spp"];
    EXPECT_GT(spp, 0u);
    EXPECT_LT(spp, 1000000u);
    EXPECT_EQ(spp % 8, 0u) << "ends on a block";
    EXPECT_EQ(attribute("lobe:partial"), "1");
    EXPECT_EQ(attribute("samplesPerPixel"), std::to_string(spp));
    EXPECT_EQ(attribute("lobe:imageHash"), json["image_hash"]);
    EXPECT_NE(result.out.find("(stopped early)"), std::string::npos) << result.out;
    EXPECT_EQ(files(), "out.exr out.json scene.pbrt");
    // What was rendered is what a whole render of as many samples gives.
    if (spp < 60000) {
        EXPECT_EQ(hash({"--spp", std::to_string(spp)}), json["image_hash"]);
    }
}

TEST_F(Stopped, TerminateDoesTheSame) {
    EXPECT_EQ(stop("32x24", SIGTERM).code, 143);
    EXPECT_LT(seconds_, 2);
    EXPECT_EQ(attribute("lobe:partial"), "1");
}

// The scene is a pipe, so that the signal comes while it is read.
TEST_F(Stopped, BeforeTheFirstSampleLeavesTheOldPicture) {
    folder_.write("out.exr", "the old picture");
    ASSERT_EQ(mkfifo(path("pipe.pbrt").c_str(), 0600), 0);
    RunOptions options;
    options.folder = folder_.path();
    Process process({LOBE_PROGRAM, "render", "pipe.pbrt", "-o", "out.exr"}, options);
    std::ofstream scene(path("pipe.pbrt"));  // waits until it is opened for reading
    process.kill(SIGINT);
    scene << small_scene;
    scene.close();
    const RunResult result = process.wait();
    EXPECT_EQ(result.code, 130);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "lobe: stopped before the first sample: nothing is written\n");
    EXPECT_EQ(read_file(path("out.exr")), "the old picture");
    EXPECT_EQ(files(), "out.exr pipe.pbrt scene.pbrt");
}

// Some of the rows are there, the others black.
TEST_F(Stopped, InTheFirstBlock) {
    const RunResult result = stop("2000x2000", SIGINT);
    EXPECT_EQ(result.code, 130);
    EXPECT_LT(seconds_, 5);  // 96 MB to write
    const ImageFile image = ImageIo().read(path("out.exr"));
    EXPECT_EQ(std::get<std::string>(image.attributes.at("lobe:partial")), "1");
    EXPECT_GT(*std::max_element(image.pixels.begin(), image.pixels.begin() + 10000), 0.0f);
    EXPECT_EQ(*std::max_element(image.pixels.end() - 10000, image.pixels.end()), 0.0f);
    EXPECT_EQ(files(), "out.exr out.json scene.pbrt");
}
