// SPDX-License-Identifier: Apache-2.0
// lobe brdf fit on files made here.
#include <cmath>

#include "cli.h"
#include "lab/fit/least_squares.h"
#include "scene/measured_files.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Modified Phong of n = 20, kd = 0.2 0.1 0.05, ks = 0.4.
MeasuredBrdf phong_table() {
    MeasuredBrdf table{{12, 8, 10}, {}};
    table.values.resize(std::size_t{12} * 8 * 10);
    for (std::size_t cell = 0; cell < table.cells(); ++cell) {
        const DirectionPair pair = directions_at(table, cell);
        const double c = glm::dot(glm::dvec3(-pair.wo.x, -pair.wo.y, pair.wo.z), pair.wi);
        const double lobe = 0.4 * std::pow(std::max(c, 0.0), 20);
        const bool above = pair.wo.z > 0 && pair.wi.z > 0;
        table.values[cell] =
            above ? glm::vec3(0.2 + lobe, 0.1 + lobe, 0.05 + lobe) : glm::vec3(NAN);
    }
    return table;
}

class BrdfFit : public Cli {
  protected:
    void SetUp() override {
        if (!has_least_squares()) GTEST_SKIP() << "this build has no Ceres";
        write_merl(path("phong.binary"), phong_table());
        write_measured_text(path("phong.txt"), phong_table());
    }

    nlohmann::json fit(std::vector<std::string> words) const {
        words.insert(words.begin(), {"brdf", "fit"});
        words.insert(words.end(), {"--json", "-", "--quiet"});
        const RunResult result = lobe(words);
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return nlohmann::json::parse(result.out, nullptr, false);
    }
};

}  // namespace

TEST_F(BrdfFit, FindsTheModelThatMadeTheFile) {
    for (const char* file : {"phong.binary", "phong.txt"}) {
        const auto json = fit({file, "--points", "300"});
        EXPECT_EQ(json["points"], 300);
        EXPECT_EQ(json["weight"], "cos");
        ASSERT_EQ(json["models"].size(), 3u);
        EXPECT_EQ(json["wins"], "modified_phong");
        const auto& best = json["models"][2];
        EXPECT_EQ(best["model"], "modified_phong");
        EXPECT_LT(double(best["cos_error_relative"]), 1e-5);
        EXPECT_TRUE(best["converged"]);
        EXPECT_NEAR(double(best["parameters"][0]["value"][1]), 0.1, 1e-4);
        EXPECT_NEAR(double(best["parameters"][1]["value"][1]), 0.4, 1e-4);
        EXPECT_NEAR(double(best["parameters"][2]["value"]), 20, 1e-2);
        EXPECT_LT(double(best["parameters"][2]["standard_error"]), 1e-2);
        EXPECT_GT(double(json["models"][0]["cos_error_relative"]), 1e-2);
    }
}

TEST_F(BrdfFit, SettingsAreHeldAndTheWeightChosen) {
    const auto json = fit({"phong.txt", "--points", "300", "--model", "modified_phong", "--set",
                           "n=10", "--weight", "log"});
    EXPECT_EQ(json["weight"], "log");
    ASSERT_EQ(json["models"].size(), 1u);
    EXPECT_EQ(json["models"][0]["parameters"].size(), 2u);
    EXPECT_GT(double(json["models"][0]["log_error"]), 0.01);
    EXPECT_EQ(fit({"phong.txt", "--points", "300", "--model", "modified_phong", "--set", "n=10",
                   "--weight", "log"})["models"][0]["parameters"],
              json["models"][0]["parameters"]);  // the same seed, the same fit
}

TEST_F(BrdfFit, ATextSaysTheSame) {
    const RunResult result = lobe({"brdf", "fit", "phong.txt", "--points", "300", "--model",
                                   "modified_phong", "--model", "lambert"});
    EXPECT_EQ(result.code, 0);
    for (const char* part : {"phong.txt: 12 x 8 x 10 cells; 300 of the ", "modified_phong    kd",
                             "cos error", "log error", "wins"})
        EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
}

TEST_F(BrdfFit, FaultsAreSaid) {
    expect_fault(lobe({"brdf", "fit", "none.txt"}), 3,
                 "none.txt: cannot read the file: No such file or directory", "spelt");
    expect_fault(lobe({"brdf", "fit", "scene.pbrt"}), 3,
                 "scene.pbrt:1:1: this is no table of reflectance", "brdf");
    expect_fault(lobe({"brdf", "fit", "phong.txt", "--model", "fong"}), 2,
                 "there is no model 'fong'", "phong");
    expect_fault(lobe({"brdf", "fit", "phong.txt", "--model", "measured"}), 2,
                 "measured is a table itself and has none to fit with", "measured.filename=FILE");
    expect_fault(
        lobe({"brdf", "fit", "phong.txt", "--model", "lambert", "--set", "kd=0.1", "--quiet"}), 2,
        "lambert has no parameter left to fit", "--set");
    EXPECT_EQ(lobe({"brdf", "fit", "phong.txt", "--weight", "cubic"}).code, 2);
    EXPECT_EQ(lobe({"brdf", "fit"}).code, 2);
}
