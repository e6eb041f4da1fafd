// SPDX-License-Identifier: Apache-2.0
// lobe brdf check: a sound model passes, each kind of error is found by its own check, and the
// report says so to people and to programs.
#include "base/files.h"
#include "cli.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class BrdfCheck : public Cli {
  protected:
    BrdfCheck() {
        EXPECT_EQ(lobe({"brdf", "new", "velvet", "--quiet"}).code, 0);
        text_ = read_file(path("velvet.cl"));
    }

    // The template with the first `old` replaced.
    void mutate(const std::string& old, const std::string& fresh) {
        std::string text = text_;
        const std::size_t at = text.find(old);
        ASSERT_NE(at, std::string::npos) << old;
        folder_.write("velvet.cl", text.replace(at, old.size(), fresh));
    }

    nlohmann::json check(int code, std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"brdf", "check", "velvet.cl", "--json", "-", "--quiet"});
        const RunResult result = lobe(more);
        EXPECT_EQ(result.code, code) << result.err << result.out;
        return result.out.empty() ? nlohmann::json() : nlohmann::json::parse(result.out);
    }

    // The error planted is found by the named check, perhaps by others too.
    void finds(const std::string& name, const std::string& old, const std::string& fresh) {
        SCOPED_TRACE(name);
        mutate(old, fresh);
        const nlohmann::json json = check(8);
        ASSERT_FALSE(json.is_null());
        EXPECT_FALSE(json["passed"]);
        bool found = false;
        for (const auto& row : json["models"][0]["checks"])
            found = found || (row["check"] == name && row["verdict"] == "FAIL");
        EXPECT_TRUE(found) << json["models"][0]["checks"].dump(1);
    }

    std::string text_;
};

}  // namespace

TEST_F(BrdfCheck, SoundModelPasses) {
    const nlohmann::json json = check(0);
    EXPECT_TRUE(json["passed"]);
    EXPECT_GT(json["level"], 0);
    const auto& checks = json["models"][0]["checks"];
    std::string names;
    for (const auto& row : checks) {
        names += row["check"].get<std::string>() + " ";
        EXPECT_NE(row["verdict"], "FAIL");
        EXPECT_GT(row["tests"], 0) << row["check"];
    }
    EXPECT_EQ(names,
              "formula precision same samples weight reciprocity horizon density chi-square albedo "
              "energy variance cubature finite garbage furnace ");
}

TEST_F(BrdfCheck, SameSeedSameFigures) {
    const auto figures = [&](const std::string& seed) {
        nlohmann::json json = check(0, {"--grid", "reduced", "--seed", seed});
        nlohmann::json& model = json["models"][0];
        model.erase("compile_s");
        model.erase("check_s");
        return model.dump();
    };
    const std::string once = figures("5");
    EXPECT_EQ(once, figures("5"));
    EXPECT_NE(once, figures("6"));
}

TEST_F(BrdfCheck, TableNamesTheWorst) {
    const RunResult result = lobe({"brdf", "check", "lambert", "--quiet", "--grid", "reduced"});
    EXPECT_EQ(result.code, 0) << result.out;
    EXPECT_NE(result.out.find("ok    lambert"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("chi-square    least p "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("(Sidak, 0.001 together)"), std::string::npos) << result.out;
}

TEST_F(BrdfCheck, UnknownModel) {
    expect_fault(lobe({"brdf", "check", "lambrt"}), 2, "there is no model 'lambrt'",
                 "did you mean 'lambert'?");
}

TEST_F(BrdfCheck, FindsAWrongValue) {
    finds("formula", "m.n = values.n;", "m.n = values.n + R(0.05);");
}

TEST_F(BrdfCheck, FindsADensityThatIsNotTheSamplers) {
    finds("density", "real rim = (m->n + 1)", "real rim = R(1.01) * (m->n + 1)");
    finds("chi-square", "u.z < m->choice.x", "u.z < R(0.95) * m->choice.x");
}

TEST_F(BrdfCheck, FindsAClaimThatDoesNotHold) {
    finds("reciprocity", "* wi.z;\n}", "* (wi.z * (1 + R(0.1) * wi.z));\n}");
    finds("energy", "REAL_PI * values.kd + ", "R(0.5) * REAL_PI * values.kd + ");
}

// A claim that is withheld though it always holds is one the model could make.
TEST_F(BrdfCheck, FindsAClaimThatIsWithheld) {
    finds("reciprocity", "return LOBE_BRDF_RECIPROCAL | ", "return ");
}

TEST_F(BrdfCheck, FindsWhatIsNoNumber) {
    finds("finite", "real_log1p(-smaller(cosine, 1))", "real_log1p(-cosine * R(1.0001))");
}
