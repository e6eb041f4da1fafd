// SPDX-License-Identifier: Apache-2.0
// Devices: none, another than there is, a driver without its cache, kernels that do not build. Exit
// code 4, with what to do about it.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/files.h"
#include "cli.h"

using namespace lobe;
using namespace lobe::test;
namespace fs = std::filesystem;

namespace {

RunOptions with(const std::string& name, const std::string& value) {
    RunOptions options;
    options.environment = {{name, value}};
    return options;
}

const std::vector<std::string> render_words{"render", "scene.pbrt", "-o", "out.exr"};

}  // namespace

TEST_F(Cli, WithoutAPlatform) {
    fs::create_directory(path("empty"));
    for (const std::vector<std::string>& words : {render_words, {"devices"}})
        expect_fault(lobe(words, with("OCL_ICD_VENDORS", path("empty"))), 4, "no OpenCL platform",
                     "apt-get install pocl-opencl-icd");
    EXPECT_EQ(files(), "empty scene.pbrt");
}

TEST_F(Cli, FeaturesNeedNoDevice) {
    EXPECT_EQ(lobe({"features", "scene.pbrt"}, with("OCL_ICD_VENDORS", "/nonexistent")).code, 0);
}

TEST_F(Cli, ADeviceThatIsNotThereListsThoseThatAre) {
    const auto devices = nlohmann::json::parse(lobe({"devices", "--json", "-"}).out);
    const std::string name = devices.at(0).at("name");
    for (const char* verb : {"render", "devices"}) {
        std::vector<std::string> words{verb};
        if (words[0] == "render") words = render_words;
        expect_fault(lobe(words, with("LOBE_DEVICE", "abacus")), 4,
                     "LOBE_DEVICE: there is no device \"abacus\"", "0 " + name);
        words.insert(words.end(), {"--device", "99"});
        expect_fault(lobe(words, with("LOBE_DEVICE", "abacus")), 4, "there is no device \"99\"",
                     "0 " + name);
        words.back() = "0";
        EXPECT_EQ(lobe(words, with("LOBE_DEVICE", "abacus")).code, 0);  // the option wins
    }
    EXPECT_EQ(files(), "out.exr scene.pbrt");
}

TEST_F(Cli, TheChosenDeviceIsMarked) {
    const RunResult text = lobe({"devices"}, with("LOBE_DEVICE", "0"));
    EXPECT_EQ(text.code, 0);
    EXPECT_EQ(text.out.compare(0, 4, "* 0 "), 0) << text.out;
    const auto devices =
        nlohmann::json::parse(lobe({"devices", "--json", "-"}, with("LOBE_DEVICE", "0")).out);
    EXPECT_EQ(devices.at(0).at("default"), true);
    for (const char* key :
         {"number", "name", "type", "platform", "driver", "version", "clock_mhz", "compute_units",
          "global_memory_bytes", "largest_allocation_bytes", "fp64"})
        EXPECT_TRUE(devices.at(0).contains(key)) << key;
}

TEST_F(Cli, UnwritableCacheOfPocl) {
    const auto devices = nlohmann::json::parse(lobe({"devices", "--json", "-"}).out);
    if (devices.size() != 1 || devices[0]["platform"] != "Portable Computing Language")
        GTEST_SKIP() << "there are other devices than PoCL's";
    const std::string folder = path("scene.pbrt") + "/cache";
    const RunResult result = lobe(render_words, with("POCL_CACHE_DIR", folder));
    expect_fault(result, 4, "no OpenCL device (platforms: Portable Computing Language)",
                 "POCL_CACHE_DIR=" + folder);
    EXPECT_EQ(files(), "scene.pbrt");
}

// Kernels of one's own are built at once; their faults come with the place and the evidence.
TEST_F(Cli, ABrokenKernelTellsWhere) {
    const std::string kernels = path("kernels"), file = kernels + "/core/warp.h";
    fs::copy(LOBE_SOURCE_DIR "/kernels", kernels, fs::copy_options::recursive);
    const std::string text = read_file(file);
    const auto line = 1 + std::count(text.begin(), text.end(), '\n');
    std::ofstream(file, std::ios::app) << "real broken(real x) { return x + ; }\n";
    std::vector<std::string> words = render_words;
    words.insert(words.end(), {"--kernel-dir", "kernels"});
    const RunResult result = lobe(words, with("LOBE_CACHE_DIR", path("evidence")));
    EXPECT_EQ(result.code, 4);
    EXPECT_EQ(result.out, "");
    const std::string error =
        "lobe: error: core/warp.h:" + std::to_string(line) + ":34: the kernel does not build: ";
    EXPECT_NE(result.err.find(error), std::string::npos) << error << "\n" << result.err;
    const std::string hint = "lobe: hint: its text and the compiler's log are in ";
    const std::size_t at = result.err.find(hint);
    ASSERT_NE(at, std::string::npos) << result.err;
    const std::size_t begin = at + hint.size();
    const std::string evidence = result.err.substr(begin, result.err.find('\n', begin) - begin);
    EXPECT_EQ(fs::path(evidence).parent_path(), path("evidence"));
    EXPECT_NE(read_file(evidence).find("return x + ;"), std::string::npos);
    EXPECT_EQ(files(), "evidence kernels scene.pbrt");
}

TEST_F(Cli, AFolderWithoutKernels) {
    fs::create_directory(path("empty"));
    for (const char* verb : {"render", "features"}) {
        expect_fault(lobe({verb, "scene.pbrt", "--kernel-dir", "none"}), 4,
                     "none: the folder of kernels cannot be read: No such file or directory",
                     "--kernel-dir");
        expect_fault(lobe({verb, "scene.pbrt", "--kernel-dir", "empty"}), 4,
                     "empty: the folder holds no kernels", "--kernel-dir");
    }
}
