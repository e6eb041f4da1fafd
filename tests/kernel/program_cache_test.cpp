// SPDX-License-Identifier: Apache-2.0
// The cache of program binaries. PoCL does not use it by itself; LOBE_PROGRAM_CACHE makes it.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "cl/binary_cache.h"
#include "support/probe.h"
#include "support/temp_folder.h"

using namespace lobe;
using namespace lobe::test;
namespace fs = std::filesystem;

namespace {

const char* const text = "kernel void seven(global int* out) { *out = 7; }";

class BinaryCache : public testing::Test {
  protected:
    // Builds and runs, and tells whether the binary came from the cache.
    bool build_and_run(const std::string& source = text) {
        const Program program = build_program(test_device(), source);
        const Buffer<int> out(test_device(), 1);
        run_probe(program, "seven", 1, out);
        EXPECT_EQ(out.read_all()[0], 7);
        save_binary(test_device(), program);
        return program.cached;
    }
    std::vector<std::string> files() const {
        std::vector<std::string> paths;
        if (fs::exists(folder_.file("cache")))
            for (const auto& entry : fs::directory_iterator(folder_.file("cache")))
                paths.push_back(entry.path().string());
        return paths;
    }
    // Replaces the cached file's bytes; the next build must not trust them, and must mend them.
    void expect_rebuilt_after(const std::string& bytes) {
        ASSERT_EQ(files().size(), 1u);
        write_file(files()[0], bytes);
        EXPECT_FALSE(build_and_run());
        EXPECT_TRUE(build_and_run());
    }

    TempFolder folder_;
    ScopedVariable place_{"LOBE_CACHE_DIR", folder_.file("cache").c_str()};
    ScopedVariable on_{"LOBE_PROGRAM_CACHE", "on"};
};

}  // namespace

TEST_F(BinaryCache, SecondBuildTakesTheBinary) {
    EXPECT_FALSE(build_and_run());
    EXPECT_EQ(files().size(), 1u);
    EXPECT_TRUE(build_and_run());
    EXPECT_FALSE(build_and_run(std::string(text) + "\n"));
    EXPECT_EQ(files().size(), 2u);
}

TEST_F(BinaryCache, NothingIsKeptBeforeItIsAsked) {
    build_program(test_device(), text);
    EXPECT_TRUE(files().empty());
}

TEST_F(BinaryCache, DamagedFilesAreRebuilt) {
    build_and_run();
    const std::string good = read_file(files().at(0));
    for (const std::size_t at :
         {std::size_t{0}, std::size_t{20}, std::size_t{90}, good.size() / 2, good.size() - 1}) {
        SCOPED_TRACE("byte " + std::to_string(at));
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 1);
        expect_rebuilt_after(bad);
    }
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{10}, std::size_t{150}, good.size() / 2, good.size() - 1}) {
        SCOPED_TRACE("length " + std::to_string(length));
        expect_rebuilt_after(good.substr(0, length));
    }
    expect_rebuilt_after(good + "x");
}

TEST_F(BinaryCache, ABadFileIsRemovedAtOnce) {
    build_and_run();
    write_file(files().at(0), "rubbish");
    EXPECT_FALSE(build_program(test_device(), text).cached);
    EXPECT_TRUE(files().empty());
}

TEST_F(BinaryCache, AnotherProgramsFileIsNotTaken) {
    build_and_run();
    const std::string first = read_file(files().at(0));
    const std::string name = fs::path(files()[0]).filename();
    fs::remove(files()[0]);
    build_and_run(std::string(text) + "// other\n");
    const std::string other = read_file(files().at(0));
    fs::remove(files()[0]);
    folder_.write("cache/" + name, other);
    EXPECT_FALSE(build_and_run());
}

TEST_F(BinaryCache, OffMeansOff) {
    const ScopedVariable off("LOBE_PROGRAM_CACHE", "off");
    EXPECT_FALSE(build_and_run());
    EXPECT_FALSE(build_and_run());
    EXPECT_TRUE(files().empty());
}

TEST_F(BinaryCache, AFolderThatCannotBeWrittenIsNoFailure) {
    const ScopedVariable nowhere("LOBE_CACHE_DIR", "/dev/null/no");
    EXPECT_FALSE(build_and_run());
    EXPECT_FALSE(build_and_run());
}

TEST_F(BinaryCache, PaysWhereTheDriverHasNoneOfItsOwn) {
    const ScopedVariable unset("LOBE_PROGRAM_CACHE", nullptr);
    DeviceInfo info;
    info.platform = "Portable Computing Language";
    EXPECT_FALSE(binary_cache_pays(info));
    info.platform = "Another";
    EXPECT_TRUE(binary_cache_pays(info));
}

TEST(CacheFolder, FollowsTheEnvironment) {
    const ScopedVariable own("LOBE_CACHE_DIR", nullptr), home("HOME", "/home/a");
    {
        const ScopedVariable xdg("XDG_CACHE_HOME", "/x");
        EXPECT_EQ(cache_folder(), "/x/lobe");
    }
    const ScopedVariable xdg("XDG_CACHE_HOME", nullptr);
    EXPECT_EQ(cache_folder(), "/home/a/.cache/lobe");
    const ScopedVariable homeless("HOME", nullptr);
    EXPECT_EQ(cache_folder(), "");
}
