// SPDX-License-Identifier: Apache-2.0
// lobe converge as a user meets it: its tables, its JSON and CSV, its reference, its errors.
#include <signal.h>

#include <algorithm>
#include <sstream>

#include "base/files.h"
#include "cli.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class Converge : public Cli {
  protected:
    std::vector<std::string> words(std::vector<std::string> more) const {
        more.insert(more.begin(), {"converge", "scene.pbrt", "--doublings", "3"});
        return more;
    }
    RunOptions cached() const {
        RunOptions options;
        options.environment = {{"LOBE_CACHE_DIR", path("cache")}, {"LC_ALL", "C"}};
        return options;
    }
    nlohmann::json measure(std::vector<std::string> more) const {
        more.insert(more.end(), {"--json", "-", "--quiet"});
        const RunResult result = lobe(words(more), cached());
        EXPECT_EQ(result.code, 0) << result.err;
        return nlohmann::json::parse(result.out, nullptr, false);
    }
};

}  // namespace

TEST_F(Converge, TellsOfErrorAndTime) {
    const RunResult result = lobe(words({"--seeds", "8", "--csv", "runs.csv"}), cached());
    EXPECT_EQ(result.code, 0) << result.err;
    for (const char* part :
         {"scene      scene.pbrt, 32x24", "sampler    sobol", "subtracted", "mask       ",
          "in which a light is seen directly, and their neighbours, are left out", "8 of 8 seeds",
          "relMSE adds epsilon", "slope      -", "fit        MSE = v/N + b2",
          "bias       none found", "start-up   ", "compile", "to unit variance", "target     1 %"})
        EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
    const std::string csv = read_file(path("runs.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 8);
    EXPECT_EQ(csv.compare(0, 20, "scene,seed,spp,wall_"), 0);
}

TEST_F(Converge, APageHoldsTheSlopeAndTheCommand) {
    const RunResult result = lobe(words({"--seeds", "8", "--html", "out.html"}), cached());
    EXPECT_EQ(result.code, 0) << result.err;
    const std::string page = read_file(path("out.html"));
    EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u) << page.substr(0, 40);
    for (const char* part : {"<svg", "converge scene.pbrt", "slope", "download="})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_EQ(page.find("src=\"http"), std::string::npos);
}

TEST_F(Converge, JsonHoldsEveryRun) {
    const auto json = measure({"--seeds", "3", "--seed", "7", "--sampler", "independent"});
    ASSERT_TRUE(json.is_object());
    EXPECT_EQ(json["schema"], 1);
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["scene"]["path"], "scene.pbrt");
    EXPECT_EQ(scene["sampler"].get<std::string>().substr(0, 11), "independent");
    EXPECT_EQ(scene["seed0"], 7);
    EXPECT_EQ(scene["reference"]["from_cache"], false);
    EXPECT_EQ(scene["reference"]["spp"], 88);  // 3 (4 + 8 + 16) in whole blocks
    EXPECT_EQ(scene["runs"].size(), 9u);
    EXPECT_EQ(scene["levels"].size(), 3u);
    EXPECT_GT(scene["fit"]["c_s_per_sample"], 0);
    EXPECT_LT(scene["fit"]["slope"], -0.3);
    EXPECT_EQ(scene["bias"]["b2_counts"], true);
    // A run can be had again by its seed.
    for (const auto& run : {scene["runs"][0], scene["runs"][5]}) {
        EXPECT_EQ(run["nonfinite"], 0);
        EXPECT_EQ(hash({"--seed", std::to_string(run["seed"].get<std::uint64_t>()), "--spp",
                        std::to_string(run["spp"].get<unsigned>()), "--sampler", "independent"}),
                  run["hash"].get<std::string>());
    }
    EXPECT_EQ(measure({"--seeds", "3"})["scenes"][0]["reference"]["from_cache"], true);
}

TEST_F(Converge, TakesAReferenceOfTheUsers) {
    EXPECT_EQ(lobe({"render", "scene.pbrt", "-o", "own.exr", "--spp", "64", "--seed", "99"}).code,
              0);
    const auto json = measure({"--seeds", "3", "--reference", "own.exr"});
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["reference"]["file"], "own.exr");
    EXPECT_GT(scene["reference"]["variance"], 0);
    EXPECT_EQ(files().find("cache"), std::string::npos);
    expect_fault(lobe(words({"--reference", "own.exr", "--resolution", "8x8", "--quiet"})), 3,
                 "own.exr: the reference is 32x24, the scene's film 8x8", "--output");
}

TEST_F(Converge, SeveralScenesEndWithASummary) {
    const RunResult result = lobe(
        {"converge", "scene.pbrt", "scene.pbrt", "--doublings", "3", "--seeds", "3", "--no-mask"},
        cached());
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("mask       none"), std::string::npos);
    EXPECT_NE(result.out.find("s to unit variance"), std::string::npos) << result.out;
    EXPECT_NE(result.err.find("3 seeds are few"), std::string::npos) << result.err;
}

TEST_F(Converge, RefusesWhatMakesNoSense) {
    expect_fault(lobe(words({"--target", "1x"})), 2, "--target '1x' is not understood", "1%");
    expect_fault(lobe(words({"--from", "3"})), 2, "--from 3 is odd", "even");
    expect_fault(lobe({"converge", "scene.pbrt", "--from", "1000000", "--doublings", "20"}), 2,
                 "--from and --doublings lead to more than 2^30 samples", "FROM times");
    EXPECT_EQ(lobe(words({"--spp", "4"})).code, 2);
    EXPECT_EQ(lobe(words({"--seeds", "2"})).code, 2);
    EXPECT_EQ(lobe({"converge", "none.pbrt"}).code, 3);
}

// What is complete is told, and the exit code says that it is not all.
TEST_F(Converge, ASignalEndsIt) {
    RunOptions options = cached();
    options.folder = folder_.path();
    options.terminal = true;
    options.environment["TERM"] = "xterm";
    Process process({LOBE_PROGRAM, "converge", "scene.pbrt", "--doublings", "3", "--seeds",
                     "100000", "--reference-spp", "8", "--json", "out.json"},
                    options);
    EXPECT_TRUE(process.wait_for_stderr("converge  "));
    process.kill(SIGINT);
    const RunResult result = process.wait();
    EXPECT_EQ(result.code, 130) << result.err;
    EXPECT_NE(result.out.find("of 100000 seeds"), std::string::npos) << result.out;
    const auto json = nlohmann::json::parse(read_file(path("out.json")));
    EXPECT_EQ(json["scenes"][0]["partial"], true);
}
