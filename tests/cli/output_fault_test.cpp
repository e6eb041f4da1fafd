// SPDX-License-Identifier: Apache-2.0
// Outputs that cannot be written: exit code 5, before rendering where that can be known, and the
// old file as it was.
#include <unistd.h>

#include <filesystem>

#include "base/files.h"
#include "cli.h"

using namespace lobe;
using namespace lobe::test;
namespace fs = std::filesystem;

namespace {

// Rendering is impossible, so a test of what is found before it cannot pass by luck.
RunOptions no_device() {
    RunOptions options;
    options.environment = {{"OCL_ICD_VENDORS", "/nonexistent"}};
    return options;
}

}  // namespace

TEST_F(Cli, UnwritableOutputIsFoundBeforeRendering) {
    fs::create_directory(path("folder.exr"));
    const std::string before = files();
    for (const char* option : {"-o", "--json"}) {
        SCOPED_TRACE(option);
        expect_fault(lobe({"render", "scene.pbrt", option, "none/out.exr"}, no_device()), 5,
                     "none/out.exr: cannot write a file in the folder none: "
                     "No such file or directory",
                     "make the folder first");
        expect_fault(lobe({"render", "scene.pbrt", option, "folder.exr"}, no_device()), 5,
                     "folder.exr: cannot write the file: Is a directory", "name a file in it");
        expect_fault(lobe({"render", "scene.pbrt", option, "scene.pbrt/out.png"}, no_device()), 5,
                     "scene.pbrt/out.png: cannot write a file in the folder scene.pbrt: "
                     "Not a directory");
    }
    EXPECT_EQ(files(), before);
}

TEST_F(Cli, OneBadOutputOfSeveralWritesNone) {
    const RunResult result =
        lobe({"render", "scene.pbrt", "-o", "good.exr", "-o", "none/bad.png"}, no_device());
    EXPECT_EQ(result.code, 5);
    EXPECT_EQ(files(), "scene.pbrt");
}

TEST_F(Cli, ReadOnlyFolder) {
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    fs::create_directory(path("locked"));
    fs::permissions(path("locked"), fs::perms::owner_read | fs::perms::owner_exec);
    expect_fault(lobe({"render", "scene.pbrt", "-o", "locked/out.exr"}, no_device()), 5,
                 "locked/out.exr: cannot write a file in the folder locked: Permission denied",
                 "that you may write to");
    fs::permissions(path("locked"), fs::perms::owner_all);
}

// The scene's own name for the picture is one that lobe cannot write.
TEST_F(Cli, AnotherFormatOfTheSceneBecomesExr) {
    write_scene("[24]", "[24] \"string filename\" \"old.tga\"");
    EXPECT_EQ(render({})["outputs"], nlohmann::json({"old.exr"}));
    EXPECT_EQ(files(), "old.exr scene.pbrt");
}

TEST_F(Cli, AFullDiskLeavesTheOldFile) {
    folder_.write("out.exr", "the old picture");
    RunOptions small;
    small.largest_file = 1 << 20;
    const std::vector<std::string> words{"render",       "scene.pbrt", "-o",    "out.exr",
                                         "--resolution", "400x400",    "--spp", "2"};
    ASSERT_EQ(lobe({"render", "scene.pbrt", "-o", "warm.exr", "--spp", "2"}).code, 0);
    const RunResult result = lobe(words, small);
    EXPECT_EQ(result.code, 5) << result.signal << result.err;
    EXPECT_EQ(result.err.find("lobe: error: out.exr: "), 0u) << result.err;
    EXPECT_EQ(read_file(path("out.exr")), "the old picture");
    EXPECT_EQ(files(), "out.exr scene.pbrt warm.exr");
}

TEST_F(Cli, ThePictureReplacesTheOldOne) {
    folder_.write("real.png", "the old picture");
    fs::create_symlink("real.png", path("link.png"));
    ASSERT_EQ(lobe({"render", "scene.pbrt", "-o", "link.png"}).code, 0);
    EXPECT_TRUE(fs::is_symlink(path("link.png")));
    EXPECT_EQ(read_file(path("real.png")).substr(1, 3), "PNG");
    EXPECT_EQ(files(), "link.png real.png scene.pbrt");
}

TEST_F(Cli, AFailedRenderLeavesTheOldPicture) {
    folder_.write("out.exr", "the old picture");
    EXPECT_EQ(lobe({"render", "scene.pbrt", "-o", "out.exr"}, no_device()).code, 4);
    EXPECT_EQ(read_file(path("out.exr")), "the old picture");
    EXPECT_EQ(files(), "out.exr scene.pbrt");
}

// The picture is written all the same, and holds no line that was meant for the terminal.
TEST_F(Cli, ResultsThatNobodyCanReadAreAnError) {
    RunOptions closed;
    closed.closed_stdout = true;
    const RunResult result = lobe({"render", "scene.pbrt", "-o", "out.exr"}, closed);
    EXPECT_EQ(result.code, 5);
    EXPECT_EQ(result.err, "lobe: error: cannot write to standard output: Bad file descriptor\n");
    EXPECT_EQ(read_file(path("scene.pbrt")), small_scene);
    EXPECT_EQ(files(), "out.exr scene.pbrt");

    RunOptions full;
    full.stdout_file = "/dev/full";
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"features", "scene.pbrt"}, {"features", "scene.pbrt", "--json", "-"}, {"--help"}}) {
        const RunResult lost = lobe(words, full);
        EXPECT_EQ(lost.code, 5) << joined(words);
        EXPECT_EQ(lost.err,
                  "lobe: error: cannot write to standard output: No space left on device\n");
    }
}

TEST_F(Cli, QuietNeedsNoStandardOutput) {
    RunOptions closed;
    closed.closed_stdout = true;
    const RunResult result = lobe({"render", "scene.pbrt", "-o", "out.exr", "--quiet"}, closed);
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(files(), "out.exr scene.pbrt");
}
