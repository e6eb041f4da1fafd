// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>

#include "support/temp_folder.h"

using namespace lobe;
using lobe::test::TempFolder;
namespace fs = std::filesystem;

namespace {

std::size_t files_in(const std::string& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

ExitCode code_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_FALSE(error.where().empty());
        return error.code();
    }
    return ExitCode::ok;
}

}  // namespace

TEST(ReadFile, GivesAllBytes) {
    const TempFolder folder;
    std::string bytes(300000, 'x');
    bytes[5] = '\0';
    bytes[6] = '\r';
    EXPECT_EQ(read_file(folder.write("a", bytes)), bytes);
    EXPECT_EQ(read_file(folder.write("empty", "")), "");
    EXPECT_FALSE(read_file("/proc/self/status").empty());  // claims to have 0 bytes
}

TEST(ReadFile, SaysWhatIsWrong) {
    const TempFolder folder;
    EXPECT_EQ(code_of([&] { read_file(folder.file("none")); }), ExitCode::scene);
    EXPECT_EQ(code_of([&] { read_file(folder.path(), ExitCode::checkpoint); }),
              ExitCode::checkpoint);
    try {
        read_file(folder.file("none"));
    } catch (const Error& error) {
        EXPECT_NE(error.message().find("No such file"), std::string::npos) << error.message();
        EXPECT_EQ(error.where(), folder.file("none"));
    }
}

TEST(WriteFile, ReplacesWholeFilesAndLeavesNothingElse) {
    const TempFolder folder;
    const std::string path = folder.file("out");
    write_file(path, "first, and longer");
    ASSERT_EQ(chmod(path.c_str(), 0640), 0);
    write_file(path, "second");
    EXPECT_EQ(read_file(path), "second");
    struct stat status;
    ASSERT_EQ(stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
    EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteFile, FollowsLinks) {
    const TempFolder folder;
    folder.write("real/target", "old");
    fs::create_symlink("real/target", folder.file("link"));
    write_file(folder.file("link"), "new");
    EXPECT_TRUE(fs::is_symlink(folder.file("link")));
    EXPECT_EQ(read_file(folder.file("real/target")), "new");
}

TEST(WriteFile, RefusesWhatCannotBeWritten) {
    const TempFolder folder;
    EXPECT_EQ(code_of([&] { write_file(folder.path(), "x"); }), ExitCode::output);
    EXPECT_EQ(code_of([&] { write_file(folder.file("no/such/folder"), "x"); }), ExitCode::output);
    EXPECT_EQ(code_of([&] { check_writable(folder.file("no/such/folder")); }), ExitCode::output);
    EXPECT_EQ(code_of([&] { check_writable(folder.file("fine")); }), ExitCode::ok);
    EXPECT_EQ(files_in(folder.path()), 0u);
    EXPECT_THROW(write_file("", "x"), Error);
}

TEST(WriteFile, NeverReplacesAPipe) {
    const TempFolder folder;
    const std::string path = folder.file("pipe");
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    const int reader = open(path.c_str(), O_RDWR | O_NONBLOCK);
    write_file(path, "hello");
    EXPECT_TRUE(fs::is_fifo(path));
    char bytes[16] = {};
    EXPECT_EQ(read(reader, bytes, sizeof bytes), 5);
    EXPECT_STREQ(bytes, "hello");
    close(reader);
}

// A device of our own, since a faulty write_file run by root would replace the machine's /dev/full.
TEST(WriteFile, AFullDeviceIsAnError) {
    const TempFolder folder;
    const std::string own = folder.file("full");
    if (geteuid() == 0 && mknod(own.c_str(), S_IFCHR | 0666, makedev(1, 7)) != 0)
        GTEST_SKIP() << "cannot make a device file";
    const std::string path = geteuid() == 0 ? own : "/dev/full";
    EXPECT_EQ(code_of([&] { write_file(path, "x"); }), ExitCode::output);
    EXPECT_TRUE(fs::is_character_file(path));
}

// A disk that is full in the middle: the limit on file sizes stands in for it.
TEST(WriteFile, FailureLeavesTheOldFile) {
    const TempFolder folder;
    const std::string path = folder.write("out", "old");
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit old_limit;
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old_limit), 0);
    const rlimit small = {1000, old_limit.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const ExitCode code = code_of([&] { write_file(path, std::string(5000, 'x')); });
    setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_EQ(code, ExitCode::output);
    EXPECT_EQ(read_file(path), "old");
    EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(AtomicFile, WithoutCommitNothingHappened) {
    const TempFolder folder;
    const std::string path = folder.write("out", "old");
    {
        const AtomicFile file(path);
        EXPECT_EQ(fs::path(file.temporary()).parent_path(), folder.path());
        EXPECT_EQ(files_in(folder.path()), 2u);
    }
    EXPECT_EQ(read_file(path), "old");
    EXPECT_EQ(files_in(folder.path()), 1u);
}
