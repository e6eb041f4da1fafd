// SPDX-License-Identifier: Apache-2.0
// What goes to standard output and standard error, and when.
#include "cli.h"

using namespace lobe::test;

namespace {

// Long enough for the bar, which shows after a tenth of a second.
const std::vector<std::string> half_a_second{"render",       "scene.pbrt", "-o",    "out.png",
                                             "--resolution", "160x120",    "--spp", "64"};

RunOptions terminal(const std::string& no_colour = "") {
    RunOptions options;
    options.terminal = true;
    options.unset = {"NO_COLOR"};
    options.environment = {{"TERM", "xterm"}};
    if (!no_colour.empty()) options.environment["NO_COLOR"] = no_colour;
    return options;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_F(Cli, ResultsOnStandardOutputNothingElse) {
    const RunResult result = lobe({"render", "scene.pbrt", "-o", "out.exr", "-o", "out.png"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    for (const char* word :
         {"picture  out.exr\npicture  out.png\n", "\nerror    ", " % relative standard error (",
          " %) at 4 samples a pixel\nmean     ", "\ntime     ", " s: parse ", "samples/s), write ",
          "\ndevice   ", "\nhash     "})
        EXPECT_TRUE(contains(result.out, word)) << word << "\n" << result.out;
    EXPECT_EQ(files(), "out.exr out.png scene.pbrt");
}

TEST_F(Cli, QuietSaysNothing) {
    std::vector<std::string> words = half_a_second;
    words.push_back("--quiet");
    const RunResult result = lobe(words, terminal());
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(files(), "out.png scene.pbrt");
}

TEST_F(Cli, QuietStillWarns) {
    write_scene(
        "LightSource \"infinite\" \"rgb L\" [.3 .3 .3]\nAttributeBegin\n    Translate 2 -2 3\n"
        "    AreaLightSource \"diffuse\" \"rgb L\" [20 20 20]",
        "AttributeBegin");
    const RunResult result = lobe({"render", "scene.pbrt", "--quiet"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err,
              "lobe: warning: scene.pbrt: the scene has no light: the picture will be black\n");
}

TEST_F(Cli, JsonOnStandardOutputIsPure) {
    const RunResult result = lobe({"render", "scene.pbrt", "--json", "-"});
    EXPECT_EQ(result.code, 0);
    EXPECT_TRUE(nlohmann::json::accept(result.out)) << result.out;
    EXPECT_EQ(result.out.back(), '\n');
    for (const char* verb : {"features", "devices"}) {
        std::vector<std::string> words{verb, "--json", "-"};
        if (words[0] == "features") words.insert(words.begin() + 1, "scene.pbrt");
        EXPECT_TRUE(nlohmann::json::accept(lobe(words).out)) << verb;
    }
}

TEST_F(Cli, ProgressIsForTerminals) {
    const RunResult plain = lobe(half_a_second);
    EXPECT_EQ(plain.err, "");
    const RunResult shown = lobe(half_a_second, terminal());
    EXPECT_TRUE(contains(shown.err, "\x1b[32m#")) << shown.err;
    EXPECT_TRUE(contains(shown.err, "samples/s  ETA ")) << shown.err;
    EXPECT_FALSE(contains(shown.err, "\n")) << shown.err;
    const std::string clear = "\r\x1b[K";
    EXPECT_EQ(shown.err.substr(shown.err.size() - clear.size()), clear);  // the bar is taken away
}

TEST_F(Cli, NoColor) {
    const RunResult shown = lobe(half_a_second, terminal("1"));
    EXPECT_TRUE(contains(shown.err, "#")) << shown.err;
    EXPECT_FALSE(contains(shown.err, "\x1b[3")) << shown.err;
    RunOptions dumb = terminal();
    dumb.environment["TERM"] = "dumb";
    EXPECT_EQ(lobe(half_a_second, dumb).err, "");
}
