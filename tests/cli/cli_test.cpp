// SPDX-License-Identifier: Apache-2.0
#include "cli.h"

#include <algorithm>
#include <filesystem>

namespace lobe::test {

namespace fs = std::filesystem;

Cli::Cli() { folder_.write("scene.pbrt", small_scene); }

RunResult Cli::lobe(const std::vector<std::string>& arguments, RunOptions options) const {
    std::vector<std::string> words{LOBE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    if (options.folder.empty()) options.folder = folder_.path();
    return run(words, options);
}

nlohmann::json Cli::render(std::vector<std::string> arguments, const RunOptions& options) const {
    if (arguments.empty() || arguments[0][0] == '-')
        arguments.insert(arguments.begin(), "scene.pbrt");
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"--json", "-"});
    const RunResult result = lobe(arguments, options);
    EXPECT_EQ(result.code, 0) << joined(arguments) << "\n" << result.err;
    const auto json = nlohmann::json::parse(result.out, nullptr, false);
    EXPECT_TRUE(json.is_object()) << joined(arguments) << "\n" << result.out;
    return json.is_object() ? json : nlohmann::json::object();
}

std::string Cli::hash(const std::vector<std::string>& arguments, const RunOptions& options) const {
    return render(arguments, options).value("image_hash", "none");
}

void Cli::write_scene(const std::string& old, const std::string& fresh) const {
    std::string text = small_scene;
    const std::size_t at = text.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    folder_.write("scene.pbrt", text.replace(at, old.size(), fresh));
}

std::string Cli::files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return joined(names);
}

void expect_fault(const RunResult& result, int code, const std::string& error,
                  const std::string& hint) {
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_EQ(result.out, "");
    const std::string first = "lobe: error: " + error + "\n";
    ASSERT_EQ(result.err.substr(0, first.size()), first) << result.err;
    const std::string rest = result.err.substr(first.size());
    if (hint.empty()) {
        EXPECT_EQ(rest, "");
        return;
    }
    EXPECT_EQ(rest.compare(0, 12, "lobe: hint: "), 0) << result.err;
    EXPECT_NE(rest.find(hint), std::string::npos) << result.err;
    EXPECT_EQ(std::count(rest.begin(), rest.end(), '\n'), 1) << result.err;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

}  // namespace lobe::test

using namespace lobe::test;

// The instrument itself: what the other tests rely on.
TEST(Process, GivesCodeOutputAndSignal) {
    const RunResult good = run({"/bin/sh", "-c", "echo a; echo b >&2; exit 7"});
    EXPECT_EQ(good.code, 7);
    EXPECT_EQ(good.out, "a\n");
    EXPECT_EQ(good.err, "b\n");
    EXPECT_EQ(run({"/bin/sh", "-c", "kill -9 $$"}).signal, 9);
    EXPECT_EQ(run({"/no/such/program"}).code, 127);
}

TEST(Process, StopsWhatTakesTooLong) {
    RunOptions options;
    options.timeout = 0.2;
    const RunResult late = run({"/bin/sh", "-c", "exec sleep 30"}, options);
    EXPECT_TRUE(late.timed_out);
    EXPECT_LT(late.seconds, 10);
}

TEST(Process, PassesWordsAndEnvironmentUntouched) {
    RunOptions options;
    options.environment = {{"LOBE_TEST_WORD", "a 'b' $c"}};
    const RunResult result = run(
        {"/bin/sh", "-c", "printf '%s|%s' \"$LOBE_TEST_WORD\" \"$1\"", "sh", "x \"y\" *"}, options);
    EXPECT_EQ(result.out, "a 'b' $c|x \"y\" *");
}

TEST(Process, LimitsFilesAndClosesStandardOutput) {
    RunOptions options;
    options.largest_file = 1024;
    const TempFolder folder;
    options.folder = folder.path();
    EXPECT_NE(run({"/bin/sh", "-c", "head -c 4000 /dev/zero > big"}, options).code, 0);
    options = {};
    options.closed_stdout = true;
    EXPECT_NE(run({"/bin/echo", "x"}, options).code, 0);
    options = {};
    options.terminal = true;
    EXPECT_EQ(run({"/bin/sh", "-c", "test -t 2 && ! test -t 1"}, options).code, 0);
}
