// SPDX-License-Identifier: Apache-2.0
// lobe bench as a user meets it: its figures, its files, two of them side by side.
#include <fstream>

#include "base/files.h"
#include "cli.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class Bench : public Cli {
  protected:
    RunResult bench(std::vector<std::string> more) const {
        more.insert(more.begin(), {"bench", "scene.pbrt", "--quick"});
        return lobe(more);
    }
    nlohmann::json measure(std::vector<std::string> more = {}) const {
        more.insert(more.end(), {"--json", "-", "--quiet"});
        const RunResult result = bench(more);
        EXPECT_EQ(result.code, 0) << result.err;
        return nlohmann::json::parse(result.out, nullptr, false);
    }
    void change(const std::string& file, const std::string& key,
                const nlohmann::json& value) const {
        auto json = nlohmann::json::parse(read_file(path(file)));
        json["scenes"][0][key] = value;
        std::ofstream(path(file)) << json;
    }
};

}  // namespace

TEST_F(Bench, TellsOfRaysSamplesAndTimes) {
    const RunResult result = bench({});
    EXPECT_EQ(result.code, 0) << result.err;
    for (const char* part :
         {"device     ", "scene      scene.pbrt, 64x64, 8 samples a pixel", "M/s, hash ",
          "error      ", "1 % takes about ", "compile cold ", "MB on the device", "camera, eight",
          "shadow", "second bounce", "host       "})
        EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
}

TEST_F(Bench, FiguresAsJson) {
    const auto json = measure();
    ASSERT_TRUE(json.is_object());
    EXPECT_EQ(json["kind"], "lobe bench");
    EXPECT_GT(json["host_bytes"], 1000000);
    ASSERT_EQ(json["scenes"].size(), 1u);
    const auto& scene = json["scenes"][0];
    for (const char* key : {"compile_cold_s", "compile_warm_s", "samples_per_s", "target_s",
                            "relative_standard_error", "device_bytes"})
        EXPECT_GT(scene[key], 0) << key;
    EXPECT_EQ(scene["rays"]["camera"]["rays"], 4096);
    for (const char* kind : {"camera", "camera, eight together", "shadow", "bounce"}) {
        EXPECT_GT(scene["rays"][kind]["rays_per_s"], 0) << kind;
        EXPECT_GT(scene["rays"][kind]["met"], 0) << kind;
    }
    EXPECT_EQ(scene["rays"]["camera"]["met"], scene["rays"]["camera, eight together"]["met"]);
    // The picture is that of a render of the same seed.
    EXPECT_EQ(scene["image_hash"], hash({"--resolution", "64x64", "--spp", "8", "--seed", "1"}));
}

TEST_F(Bench, TwoReportsSideBySide) {
    ASSERT_EQ(bench({"--json", "a.json"}).code, 0);
    write_file(path("b.json"), read_file(path("a.json")));
    change("b.json", "device_bytes", 1);
    const RunResult same = lobe({"bench", "--compare", "a.json", "b.json"});
    EXPECT_EQ(same.code, 0) << same.err;
    for (const char* part :
         {"A  a.json: lobe ", "B  b.json: lobe ", "scene.pbrt: the same picture to the bit",
          "rays/s, camera", "1.000", "0.000"})
        EXPECT_NE(same.out.find(part), std::string::npos) << part << "\n" << same.out;
    change("b.json", "image_hash", "another");
    EXPECT_NE(lobe({"bench", "--compare", "a.json", "b.json"}).out.find("other bits"),
              std::string::npos);
    change("b.json", "spp", 9);
    expect_fault(lobe({"bench", "--compare", "a.json", "b.json"}), 8,
                 "b.json: the two reports have no scene in common",
                 "a scene is the same by name, resolution and samples a pixel");
}

TEST_F(Bench, OnlyReportsAreCompared) {
    folder_.write("text.json", "no JSON");
    folder_.write("other.json", "{\"kind\": \"another\"}");
    expect_fault(lobe({"bench", "--compare", "text.json", "other.json"}), 8,
                 "text.json: the file is no JSON", "");
    expect_fault(lobe({"bench", "--compare", "other.json", "other.json"}), 8,
                 "other.json: this is no report of lobe bench",
                 "write one with: lobe bench --json FILE");
    EXPECT_EQ(lobe({"bench", "--compare", "text.json"}).code, 2);
}

TEST_F(Bench, GrowthIsPlotted) {
    const RunResult result = bench({"--growth", "--html", "page.html", "--json", "out.json"});
    EXPECT_EQ(result.code, 0) << result.err;
    const auto growth = nlohmann::json::parse(read_file(path("out.json")))["growth"];
    ASSERT_EQ(growth.size(), 4u);
    for (const auto& series : growth) {
        ASSERT_EQ(series["points"].size(), 2u) << series;
        EXPECT_EQ(series["end"], "");
        EXPECT_LT(series["points"][0]["size"], series["points"][1]["size"]);
        for (const auto& point : series["points"]) EXPECT_GT(point["s_per_sample"], 0) << point;
    }
    EXPECT_LT(growth[0]["points"][0]["device_bytes"], growth[0]["points"][1]["device_bytes"]);
    const std::string page = read_file(path("page.html"));
    EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u) << page.substr(0, 40);
    for (const char* part : {"What grows with triangles", "What grows with lights",
                             "What grows with pixels across", "What grows with samples a pixel"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}
