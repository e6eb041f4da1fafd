// SPDX-License-Identifier: Apache-2.0
// Command lines: help, version, and what is no command line. No device is asked for any of it.
#include "cli.h"

using namespace lobe::test;

namespace {

const std::vector<std::string> verbs{"render", "features", "devices"};

// Without any OpenCL, so that a test that would render fails at once.
RunOptions no_device() {
    RunOptions options;
    options.environment = {{"OCL_ICD_VENDORS", "/nonexistent"}};
    return options;
}

struct BadOption {
    std::vector<std::string> words;
    std::string error, hint;
};

const std::string render_help = "see `lobe render --help`";

}  // namespace

TEST_F(Cli, EveryVerbHasHelpAndVersion) {
    const RunResult all = lobe({"--help"}, no_device());
    EXPECT_EQ(all.code, 0);
    EXPECT_EQ(all.err, "");
    for (const std::string& verb : verbs) {
        EXPECT_NE(all.out.find("\n  " + verb + " "), std::string::npos) << all.out;
        const RunResult help = lobe({verb, "--help"}, no_device());
        EXPECT_EQ(help.code, 0);
        EXPECT_EQ(help.err, "");
        for (const char* word : {"Usage: lobe ", "--json", "--device", "--kernel-dir", "--quiet"})
            EXPECT_NE(help.out.find(word), std::string::npos) << word << "\n" << help.out;
        EXPECT_EQ(help.out.find("UINT"), std::string::npos) << help.out;
        const RunResult version = lobe({verb, "--version"}, no_device());
        EXPECT_EQ(version.code, 0);
        EXPECT_EQ(version.out, lobe({"--version"}).out);
        EXPECT_EQ(version.out.compare(0, 5, "lobe "), 0);
    }
}

TEST_F(Cli, AVerbIsNeeded) {
    expect_fault(lobe({}), 2, "a verb is missing",
                 "choose one of: render, compare, bench, converge, features, devices");
    expect_fault(lobe({"rendr", "scene.pbrt"}), 2, "unknown verb 'rendr'",
                 "did you mean 'render'?");
    expect_fault(lobe({"--spp", "4"}), 2, "unknown option '--spp'", "choose one of: render");
}

TEST_F(Cli, ASceneMayHaveTheNameOfAVerb) {
    folder_.write("devices", "Nonsense\n");
    expect_fault(lobe({"render", "devices"}), 3, "devices:1:1: unknown directive 'Nonsense'",
                 "choose one of");
}

TEST_F(Cli, BadOptionsAreUsageErrorsBeforeTheSceneIsRead) {
    const std::vector<BadOption> table{
        {{"--sp", "4"}, "unknown option '--sp'", "did you mean '--spp'?"},
        {{"--spp=4", "--outptu=x.exr"}, "unknown option '--outptu=x.exr'", "'--output'"},
        {{"-x"}, "unknown option '-x'", render_help},
        {{"other.pbrt"}, "one argument too many: 'other.pbrt'", render_help},
        {{"--spp"}, "--spp: 1 required NUMBER missing", render_help},
        {{"--spp", "0"}, "--spp: '0' is no whole number from 1 to 1073741824", render_help},
        {{"--spp", "-4"}, "--spp: '-4' is no whole number from 1 to 1073741824", render_help},
        {{"--spp", "4x"}, "--spp: '4x' is no whole number from 1 to 1073741824", render_help},
        {{"--spp", "4294967297"},
         "--spp: '4294967297' is no whole number from 1 to 1073741824",
         render_help},
        {{"--seed", "-1"},
         "--seed: '-1' is no whole number from 0 to 18446744073709551615",
         render_help},
        {{"--max-depth", "-1"},
         "--max-depth: '-1' is no whole number from 0 to 1048576",
         render_help},
        {{"--n", "nan"}, "--n: 'nan' is no number from 0 to inf", render_help},
        {{"--n", "-1"}, "--n: '-1' is no number from 0 to inf", render_help},
        {{"--exposure", "nan"}, "--exposure: 'nan' is no number from 1e-30 to 1e30", render_help},
        {{"--exposure", "0"}, "--exposure: '0' is no number from 1e-30 to 1e30", render_help},
        {{"--resolution", "32"}, "--resolution '32' is not understood", "WIDTHxHEIGHT"},
        {{"--resolution", "0x24"}, "--resolution '0x24' is not understood", "WIDTHxHEIGHT"},
        {{"--resolution", "32x"}, "--resolution '32x' is not understood", "WIDTHxHEIGHT"},
        {{"--resolution", "1.5x2"}, "--resolution '1.5x2' is not understood", "WIDTHxHEIGHT"},
        {{"--resolution", "nanxnan"}, "--resolution 'nanxnan' is not understood", "WIDTHxHEIGHT"},
        {{"--resolution", "8x8x8"}, "--resolution '8x8x8' is not understood", "WIDTHxHEIGHT"},
        {{"--crop", "0,1"}, "--crop '0,1' is not understood", "X0,X1,Y0,Y1"},
        {{"--crop", "0.5,0.5,0,1"}, "--crop '0.5,0.5,0,1' is not understood", "X0,X1,Y0,Y1"},
        {{"--crop", "0,1,0,1.5"}, "--crop '0,1,0,1.5' is not understood", "from 0 to 1"},
        {{"--crop", "nan,1,0,1"}, "--crop 'nan,1,0,1' is not understood", "from 0 to 1"},
        {{"--filter", "bx"}, "--filter 'bx' is not understood", "box, triangle"},
        {{"--filter", "box:"}, "--filter 'box:' is not understood", "box:0.5"},
        {{"--filter", "box:-1"}, "--filter 'box:-1' is not understood", "box:0.5"},
        {{"--filter", "box:nan"}, "--filter 'box:nan' is not understood", "box:0.5"},
        {{"--replace", "plastic"}, "--replace 'plastic' is not understood", "TYPE=MODEL"},
        {{"--replace", "=phong"}, "--replace '=phong' is not understood", "TYPE=MODEL"},
        {{"--dialect", "v5"}, "--dialect: v5 not in {auto,v3,v4}", render_help},
        {{"--features", "none"}, "--features: none not in {auto,all}", render_help},
        {{"-o", "out.jpg"}, "out.jpg: cannot write a picture of type '.jpg'", ".exr"},
        {{"-o", "out"}, "out: cannot write a picture of type ''", ".png"},
        {{"-o", ""}, "cannot write a picture of type ''", ".png"},
    };
    for (const BadOption& bad : table) {
        SCOPED_TRACE(joined(bad.words));
        std::vector<std::string> words{"render", "missing.pbrt"};
        words.insert(words.end(), bad.words.begin(), bad.words.end());
        expect_fault(lobe(words, no_device()), 2, bad.error, bad.hint);
    }
    EXPECT_EQ(files(), "scene.pbrt");
}

TEST_F(Cli, ReplaceNamesAModelThatThereIs) {
    expect_fault(lobe({"render", "scene.pbrt", "--replace", "diffuse=phon"}, no_device()), 2,
                 "--replace names an unknown model 'phon'", "did you mean 'phong'?");
}

TEST_F(Cli, TheSceneIsNeeded) {
    for (const char* verb : {"render", "features"})
        expect_fault(lobe({verb}), 2, "scene is required",
                     "see `lobe " + std::string(verb) + " --help`");
}
