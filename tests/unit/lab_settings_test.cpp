// SPDX-License-Identifier: Apache-2.0
// Parameters as they are typed: what is understood, and what is said of the rest.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "lab/settings.h"

using namespace lobe;

namespace {

BrdfTable model() {
    return parse_brdf_table("brdf/test.h",
                            "// A model: f.\n#define test_parameters(P) \\\n"
                            "    P(color, kd, 0.25, 0, 1, \"colour\") \\\n"
                            "    P(number, n, 100, 0.5, inf, \"number\") \\\n"
                            "    P(integer, k, 3, 1, 9, \"whole\") \\\n"
                            "    P(choice, lobe, 0, 0, 1, \"clamp|abs: choice\")\n");
}

Subject with(const std::vector<std::string>& texts) {
    std::vector<Setting> settings;
    for (const std::string& text : texts) settings.push_back(parse_setting(text));
    check_settings({model()}, settings);
    return set_up(model(), settings);
}

void expect_refused(const std::string& text, const std::string& what, const std::string& hint) {
    try {
        with({text});
        ADD_FAILURE() << text;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_EQ(std::string(error.what()), what);
        EXPECT_NE(error.hint().find(hint), std::string::npos) << error.hint();
    }
}

}  // namespace

TEST(Settings, WhatIsTypedIsWhatIsSet) {
    const Subject plain = with({});
    EXPECT_EQ(plain.rows, model().default_rows());
    EXPECT_EQ(plain.text(), "defaults");
    const Subject s = with({"kd=0.1,0.2,0.3", "n=1e6", "test.k=7", "lobe=abs"});
    EXPECT_EQ(s.rows[0], (std::array<float, 4>{0.1f, 0.2f, 0.3f, 0}));
    EXPECT_EQ(s.rows[1][0], 1e6f);
    EXPECT_EQ(s.rows[2][0], 7.0f);
    EXPECT_EQ(s.rows[3][0], 1.0f);
    EXPECT_EQ(s.text(), "kd 0.1 0.2 0.3, n 1e+06, k 7, lobe abs");
    EXPECT_EQ(with({"kd=0.5"}).rows[0], (std::array<float, 4>{0.5f, 0.5f, 0.5f, 0}));
    EXPECT_TRUE(std::isinf(with({"n=inf"}).rows[1][0]));
    EXPECT_EQ(with({"n=3", "n=4"}).rows[1][0], 4.0f);
}

TEST(Settings, AnotherModelsAreLeftAlone) {
    const Setting theirs = parse_setting("phong.n=7");
    EXPECT_EQ(theirs.model, "phong");
    EXPECT_EQ(set_up(model(), {theirs}).rows, model().default_rows());
    // The point of a number is none of a model's.
    EXPECT_EQ(parse_setting("n=0.5").model, "");
}

TEST(Settings, WhatMakesNoSenseIsRefusedWithWhatWould) {
    for (const char* text : {"n", "=3", "n=", ""})
        expect_refused(text, std::string("--set '") + text + "' is not understood",
                       "[MODEL.]NAME=VALUE");
    for (const char* value : {"x", "3x", "0.25", "-1", "nan", "1,2"})
        expect_refused(std::string("n=") + value,
                       std::string("--set n=") + value + " is not understood",
                       "n is a number from 0.5 to inf");
    for (const char* value : {"2.5", "0", "10", "inf"})
        expect_refused(std::string("k=") + value,
                       std::string("--set k=") + value + " is not understood",
                       "k is a whole number from 1 to 9");
    for (const char* value : {"1,2", "0.1,0.2,2", "a,b,c", "inf"})
        expect_refused(std::string("kd=") + value,
                       std::string("--set kd=") + value + " is not understood",
                       "kd is one number or three, R,G,B, from 0 to 1");
    expect_refused("lobe=ab", "--set lobe has no choice 'ab'", "did you mean 'abs'?");
    expect_refused("m=3", "--set m is a parameter of none of the models", "choose one of: k, kd");
    expect_refused("phong.n=3", "--set phong.n is a parameter of none of the models", "");
}
