// SPDX-License-Identifier: Apache-2.0
// lobe brdf check --extremes: a table for people, the same for programs, and an exit code.
#include "base/files.h"
#include "cli.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class BrdfExtremesReport : public Cli {
  protected:
    BrdfExtremesReport() {
        EXPECT_EQ(lobe({"brdf", "new", "velvet", "--quiet"}).code, 0);
        text_ = read_file(path("velvet.cl"));
    }

    RunResult report(std::vector<std::string> more) const {
        more.insert(more.begin(), {"brdf", "check", "--extremes", "--grid", "reduced", "--quiet"});
        return lobe(more);
    }

    // The template with the first `old` replaced.
    void mutate(const std::string& old, const std::string& fresh) {
        std::string text = text_;
        const std::size_t at = text.find(old);
        ASSERT_NE(at, std::string::npos) << old;
        folder_.write("velvet.cl", text.replace(at, old.size(), fresh));
    }

    std::string text_;
};

}  // namespace

TEST_F(BrdfExtremesReport, ATableForPeople) {
    const RunResult result = report({"velvet.cl"});
    EXPECT_EQ(result.code, 0) << result.err << result.out;
    for (const char* text : {"velvet", "n near the mirror direction", "n at grazing angles",
                             "printed formula", "ours", "limit", "1+ulp", "1000", "1 models"})
        EXPECT_NE(result.out.find(text), std::string::npos) << text;
    EXPECT_EQ(result.out.find("FAIL\n"), std::string::npos);
}

TEST_F(BrdfExtremesReport, TheSameForPrograms) {
    const RunResult result = report({"velvet.cl", "lambert", "--json", "-"});
    ASSERT_EQ(result.code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_TRUE(json["passed"]);
    ASSERT_EQ(json["models"].size(), 2u);
    const auto& velvet = json["models"][0];
    EXPECT_EQ(velvet["model"], "velvet");
    ASSERT_EQ(velvet["blocks"].size(), 6u);  // two kinds of directions, three of colours
    const auto& row = velvet["blocks"][0]["rows"][0];
    EXPECT_EQ(row["value"], 1);
    for (const char* form : {"formula", "ours"})
        for (const char* key : {"worst", "median", "nonfinite", "negative"})
            EXPECT_TRUE(row[form].contains(key)) << form << " " << key;
    for (const char* key : {"limit", "same_floats_worst", "excess"})
        EXPECT_TRUE(row.contains(key)) << key;
    // A model without numbers has its defaults.
    EXPECT_EQ(json["models"][1]["blocks"][0]["parameter"], "");
    // The same again, but for the seconds.
    auto again = nlohmann::json::parse(report({"velvet.cl", "lambert", "--json", "-"}).out);
    for (auto& model : again["models"]) model.erase("compile_s"), model.erase("measure_s");
    auto first = json["models"];
    for (auto& model : first) model.erase("compile_s"), model.erase("measure_s");
    EXPECT_EQ(again["models"], first);
}

TEST_F(BrdfExtremesReport, WhatFailsIsNamedAndTheExitCodeIs8) {
    mutate("return real_exp(n * real_log1p(-smaller(cosine, 1)));",
           "return LOBE_DOUBLE ? exp(n * log1p(-smaller(cosine, 1))) : 1 - n * cosine;");
    const RunResult result = report({"velvet.cl"});
    EXPECT_EQ(result.code, 8) << result.err;
    EXPECT_NE(result.out.find("\nFAIL  velvet"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("  FAIL\n"), std::string::npos) << result.out;
    const auto json = nlohmann::json::parse(report({"velvet.cl", "--json", "-"}).out);
    EXPECT_FALSE(json["passed"]);
    int negative = 0;
    for (const auto& block : json["models"][0]["blocks"])
        for (const auto& row : block["rows"]) negative += int(row["ours"]["negative"]);
    EXPECT_GT(negative, 0);
    EXPECT_GT(json["models"][0]["blocks"][0]["rows"].back()["excess"], 1);
}
