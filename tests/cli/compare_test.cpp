// SPDX-License-Identifier: Apache-2.0
// lobe compare: verdicts on pictures small enough to be rendered hundreds of times.
#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "cli.h"

using namespace lobe::test;

namespace {

using Json = nlohmann::json;

// A wall under a lamp: smooth, so that Sobol's points gain much.
const char* const smooth_scene = R"(LookAt 0 -4 2  0 0 0.5  0 0 1
Camera "perspective" "float fov" [40]
Film "rgb" "integer xresolution" [16] "integer yresolution" [16]
Integrator "path" "integer maxdepth" [1]
WorldBegin
AttributeBegin
    Translate 2 -2 3
    AreaLightSource "diffuse" "rgb L" [20 20 20]
    Shape "sphere" "float radius" [.3]
AttributeEnd
Material "diffuse" "rgb reflectance" [.5 .5 .5]
Shape "trianglemesh" "point3 P" [-5 -5 0 5 -5 0 5 5 0 -5 5 0] "integer indices" [0 1 2 0 2 3]
)";

class Compare : public Cli {
  protected:
    // lobe compare smooth.pbrt ARGUMENTS... with six seeds and the JSON that it writes.
    Json compare(std::vector<std::string> arguments, int code = 0) const {
        lobe::test::RunResult result = run(arguments, code);
        return result.code == code ? Json::parse(lobe::read_file(path("out.json"))) : Json();
    }
    RunResult run(std::vector<std::string> arguments, int code = 0) const {
        lobe::write_file(path("smooth.pbrt"), smooth_scene);
        arguments.insert(arguments.begin(), {"compare", "smooth.pbrt", "--seeds", "8", "--json",
                                             "out.json", "--reference-spp", "1024"});
        const RunResult result = lobe(arguments);
        EXPECT_EQ(result.code, code) << joined(arguments) << result.err;
        return result;
    }
};

std::vector<Json> rows_of(const Json& json, const std::string& table) {
    std::vector<Json> rows;
    for (const Json& row : json["scenes"][0]["rows"])
        if (row["table"] == table) rows.push_back(row);
    return rows;
}

bool decided(const Json& row) { return row["verdict"] == "WIN" || row["verdict"] == "LOSS"; }

}  // namespace

// With the same seeds it is the same picture; with others, noise that decides nothing.
TEST_F(Compare, AThingWithItselfIsNoWin) {
    const Json same = compare({});
    ASSERT_EQ(rows_of(same, "equal_samples").size(), 2u);
    for (const Json& row : rows_of(same, "equal_samples")) {
        EXPECT_EQ(row["verdict"], "TIE");
        EXPECT_EQ(row["ratio"], 1);
    }
    ASSERT_EQ(rows_of(same, "equal_time").size(), 4u);
    const Json other = compare({"--own-seeds"});
    for (const Json& row : rows_of(other, "equal_samples")) {
        EXPECT_FALSE(decided(row)) << row;
        EXPECT_NE(row["ratio"], 1);
    }
    EXPECT_EQ(other["scenes"][0]["same_content"], true);
}

TEST_F(Compare, SobolBeatsIndependentNumbers) {
    const Json json =
        compare({"--b", "--sampler independent", "--by", "samples", "--expect", "win"});
    for (const Json& row : rows_of(json, "equal_samples")) EXPECT_EQ(row["verdict"], "WIN") << row;
    // The gain grows with the samples, at 64 beyond chance.
    const auto rows = rows_of(json, "equal_samples");
    EXPECT_GT(rows[1]["lo"], rows[0]["ratio"]);
    EXPECT_EQ(json["scenes"][0]["same_content"], true);
    // The other way round it is a loss, and not what was expected.
    const RunResult result =
        run({"--a", "--sampler independent", "--by", "samples", "--expect", "win"}, 8);
    EXPECT_NE(result.err.find("expected 'win', found 'loss'"), std::string::npos) << result.err;
}

TEST_F(Compare, TextEndsInASentence) {
    const RunResult result = run({"--b", "--max-depth 2", "--by", "samples"});
    const std::string last = result.out.substr(result.out.rfind('\n', result.out.size() - 2) + 1);
    EXPECT_EQ(last.find("At equal samples "), 0u) << last;
    EXPECT_NE(result.out.find("B/A"), std::string::npos);
    EXPECT_NE(result.out.find("--max-depth 2"), std::string::npos);
    EXPECT_NE(result.out.find("none that sees a light directly"),
              std::string::npos);  // the mask is stated
}

// Runs of unequal cost get samples that take the same time.
TEST_F(Compare, EqualTimeIsAboutEqual) {
    const Json json =
        compare({"--resolution", "48x48", "--b", "--features all", "--csv", "out.csv"});
    for (const Json& row : rows_of(json, "equal_time")) {
        EXPECT_EQ(row["samples_a"].get<int>() % 2, 0);
        EXPECT_EQ(row["samples_b"].get<int>() % 2, 0);
        EXPECT_GT(row["render_s_a"], 0);
    }
    EXPECT_EQ(rows_of(json, "equal_time").back()["samples_a"], 64);
    const std::string csv = lobe::read_file(path("out.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 6 * 8);
}

TEST_F(Compare, SeveralScenes) {
    lobe::write_file(path("smooth.pbrt"), smooth_scene);
    const RunResult result =
        lobe({"compare", "--scenes", "smooth.pbrt", "scene.pbrt", "--resolution", "16x16",
              "--b=--sampler independent", "--seeds", "8", "--reference-spp", "256", "--by",
              "samples", "--json", "out.json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json json = Json::parse(lobe::read_file(path("out.json")));
    EXPECT_EQ(json["scenes"].size(), 2u);
    EXPECT_EQ(json["scenes"][1]["b"]["scene"], "scene.pbrt");
    EXPECT_EQ(json["combined"].size(), 6u);
    EXPECT_EQ(json["headline"]["verdict"], "WIN");
    for (std::size_t r = 0; r < 2; ++r) {
        const Json &first = json["scenes"][0]["rows"][r], &second = json["scenes"][1]["rows"][r];
        const double product = first["ratio"].get<double>() * second["ratio"].get<double>();
        EXPECT_NEAR(json["combined"][r]["ratio"], std::sqrt(product), 1e-9 * product);
        EXPECT_GE(first["p_holm"], first["p"]);
    }
    EXPECT_NE(result.out.find("All 2 scenes"), std::string::npos);
}

TEST_F(Compare, APageHoldsVerdictsAndTheCommand) {
    run({"--b=--sampler independent", "--html", "out.html"});
    const std::string page = lobe::read_file(path("out.html"));
    EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u) << page.substr(0, 40);
    for (const char* part : {"<svg", "--sampler independent", "WIN", "at equal", "download="})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_EQ(page.find("src=\"http"), std::string::npos);
}

TEST_F(Compare, OptionErrorsNameTheArm) {
    expect_fault(lobe({"compare", "scene.pbrt", "--b", "--sampel independent"}), 2,
                 "in --b: unknown option '--sampel'", "did you mean '--sampler'?");
    expect_fault(lobe({"compare", "scene.pbrt", "--a", "--max-depth x"}), 2,
                 "in --a: --max-depth: 'x' is no whole number from 0 to 1048576",
                 "lobe compare --help");
    expect_fault(lobe({"compare", "scene.pbrt", "--a", "other.pbrt"}), 2,
                 "in --a: one argument too many: 'other.pbrt'", "lobe compare --help");
    expect_fault(lobe({"compare", "scene.pbrt", "--b", "--brdf 'velvet.cl"}), 2,
                 "in --b: a quote ' has no end: --brdf 'velvet.cl", "close it");
    expect_fault(lobe({"compare", "scene.pbrt", "--b", "--spp 4"}), 2,
                 "in --b: --spp is the experiment's choice", "for both");
    expect_fault(lobe({"compare", "scene.pbrt", "--b", "--resolution '8 x'"}), 2,
                 "in --b: --resolution '8 x' is not understood", "700x700");
    expect_fault(lobe({"compare"}), 2, "a scene is missing", "--scenes");
    expect_fault(lobe({"compare", "scene.pbrt", "--scenes", "scene.pbrt"}), 2,
                 "scenes are given in two ways", "--scenes");
    expect_fault(lobe({"compare", "scene.pbrt", "--b", "--resolution 8x8", "--quiet"}), 2,
                 "the films differ: A has 32x24 pixels, B 8x8", "--resolution 32x24");
    expect_fault(lobe({"compare", "none.pbrt"}), 3,
                 "none.pbrt: cannot read the file: No such file or directory", "spelt");
}
