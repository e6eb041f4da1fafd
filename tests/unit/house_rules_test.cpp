// SPDX-License-Identifier: Apache-2.0
// What the design asks of every source file: which folders it may include, its first line, its
// length. The rules are tables here and nowhere else.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "base/files.h"

using namespace lobe;
namespace fs = std::filesystem;

namespace {

using Arrows = std::map<std::string, std::set<std::string>>;

// Folder of host/ -> folders that its files may include.
const Arrows host_arrows = {
    {"base", {"base"}},
    {"cl", {"base", "cl"}},
    {"scene", {"base", "scene"}},
    {"build", {"base", "scene", "build"}},
    {"render", {"base", "cl", "scene", "build", "render"}},
    {"report", {"base", "cl", "scene", "build", "render", "report"}},
    {"lab", {"base", "cl", "scene", "build", "render", "report", "lab"}},
    {"study", {"base", "cl", "scene", "build", "render", "report", "lab", "study"}},
    {"app", {"base", "cl", "scene", "build", "render", "report", "lab", "study", "app"}},
};

// The same for kernels/. A light is a shape that shines, so light knows geom.
const Arrows kernel_arrows = {
    {"shared", {}},
    {"core", {"core"}},
    {"brdf", {"core", "brdf"}},
    {"geom", {"core", "geom"}},
    {"light", {"core", "geom", "light"}},
    {"texture", {"core", "texture"}},
    {"path", {"core", "brdf", "geom", "light", "texture", "path"}},
    {"probe", {"core", "brdf", "geom", "light", "texture", "path", "probe"}},
    {"bench", {"core", "geom", "light", "path"}},
    {"", {"core", "brdf", "geom", "light", "texture", "path"}},  // render.cl
};

struct Source {
    std::string path;  // from the root: "host/base/error.h"
    std::vector<std::string> lines;
};

std::vector<Source> sources_below(const std::string& folder) {
    static const std::set<std::string> kinds = {".cpp",   ".h",   ".cl", ".def",
                                                ".cmake", ".txt", ".py", ""};
    const fs::path root = LOBE_SOURCE_DIR;
    std::vector<Source> sources;
    if (!fs::exists(root / folder)) return sources;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const fs::path name = entry.path().filename();
        const bool wanted = name.extension() == ".txt" ? name == "CMakeLists.txt"
                                                       : kinds.count(name.extension()) > 0;
        if (!entry.is_regular_file() || !wanted) continue;
        Source source{fs::relative(entry.path(), root).generic_string(), {}};
        std::istringstream text(read_file(entry.path().string()));
        for (std::string line; std::getline(text, line);) source.lines.push_back(line);
        sources.push_back(source);
    }
    return sources;
}

// "a/b/c.h" -> "a", "c.h" -> "".
std::string first_folder(const std::string& path) {
    const auto slash = path.find('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
}

// The includes of a file under `top` that no arrow allows. Both trees may read kernels/shared, and
// kernels the texts that the host generates (lobe_scene.h) or the build makes (layout.def).
std::vector<std::string> forbidden_includes(const Source& source, const std::string& top,
                                            const Arrows& arrows) {
    static const std::regex include("[ \t]*#[ \t]*include[ \t]*\"([^\"]+)\".*");
    const std::string folder = first_folder(source.path.substr(top.size() + 1));
    const auto allowed = arrows.find(folder);
    if (allowed == arrows.end()) return {"the folder is not part of the design"};
    std::vector<std::string> found;
    for (const std::string& line : source.lines) {
        std::smatch match;
        if (!std::regex_match(line, match, include)) continue;
        const std::string to = first_folder(match.str(1));
        const bool generated = top == "kernels" && to.empty();
        if (to != "shared" && !generated && !allowed->second.count(to)) found.push_back(line);
    }
    return found;
}

std::string guard_of(const std::string& path) {
    std::string name = "LOBE_";
    for (const char c : path.substr(path.find('/') + 1))
        name +=
            std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::toupper(c)) : '_';
    return name;
}

std::vector<Source> all_sources() {
    std::vector<Source> all;
    for (const char* folder : {"host", "kernels", "tests", "tools"})
        for (Source& source : sources_below(folder)) all.push_back(std::move(source));
    return all;
}

}  // namespace

TEST(HouseRules, ArrowsPointOneWayInHost) {
    const auto sources = sources_below("host");
    ASSERT_GT(sources.size(), 20u);
    for (const Source& source : sources)
        for (const std::string& line : forbidden_includes(source, "host", host_arrows))
            ADD_FAILURE() << source.path << ": " << line;
}

TEST(HouseRules, ArrowsPointOneWayInKernels) {
    const auto sources = sources_below("kernels");
    ASSERT_GT(sources.size(), 10u);
    for (const Source& source : sources)
        for (const std::string& line : forbidden_includes(source, "kernels", kernel_arrows))
            ADD_FAILURE() << source.path << ": " << line;
}

TEST(HouseRules, WrongArrowsAreSeen) {
    const auto count = [](const char* path, const char* line, const char* top,
                          const Arrows& arrows) {
        return forbidden_includes({path, {line}}, top, arrows).size();
    };
    EXPECT_EQ(count("host/cl/a.h", "#include \"scene/scene.h\"", "host", host_arrows), 1u);
    EXPECT_EQ(count("host/cl/a.h", "  # include  \"core/real.h\"", "host", host_arrows), 1u);
    EXPECT_EQ(count("host/cl/a.h", "#include \"shared/types.h\"", "host", host_arrows), 0u);
    EXPECT_EQ(count("host/misc/a.h", "", "host", host_arrows), 1u);
    EXPECT_EQ(count("kernels/core/a.h", "#include \"geom/ray.h\"", "kernels", kernel_arrows), 1u);
    EXPECT_EQ(count("kernels/render.cl", "#include \"probe/x.h\"", "kernels", kernel_arrows), 1u);
    EXPECT_EQ(count("kernels/render.cl", "#include \"lobe_scene.h\"", "kernels", kernel_arrows),
              0u);
}

TEST(HouseRules, EveryFileSaysItsLicenceFirst) {
    for (const Source& source : all_sources()) {
        ASSERT_GE(source.lines.size(), 2u) << source.path;
        const bool script = source.lines[0].compare(0, 2, "#!") == 0;
        EXPECT_NE(source.lines[script ? 1 : 0].find("SPDX-License-Identifier: Apache-2.0"),
                  std::string::npos)
            << source.path;
    }
}

TEST(HouseRules, NoFileIsLongerThan400Lines) {
    for (const Source& source : all_sources()) EXPECT_LE(source.lines.size(), 400u) << source.path;
}

// The flattener relies on it: a header's guard is its first directive.
TEST(HouseRules, HeadersAreIncludedOnce) {
    for (const Source& source : all_sources()) {
        if (fs::path(source.path).extension() != ".h") continue;
        const auto directive = std::find_if(source.lines.begin(), source.lines.end(),
                                            [](const std::string& line) { return line[0] == '#'; });
        ASSERT_NE(directive, source.lines.end()) << source.path;
        const bool kernel = source.path.compare(0, 8, "kernels/") == 0;
        EXPECT_EQ(*directive, kernel ? "#ifndef " + guard_of(source.path) : "#pragma once")
            << source.path;
    }
}
