// SPDX-License-Identifier: Apache-2.0
#include "lab/parameter_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace lobe;

namespace {

const char* const table = R"(
#define glossy_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse part") \
    P(number, n, 100, 0, inf, "exponent") \
    P(number, rough, 0.1, 0.01, 2, "roughness") \
    P(integer, layers, 2, 1, 4, "layers") \
    P(choice, form, 0, 0, 2, "plain|round|square: form")
)";

std::set<float> values_of(const std::vector<ParameterSet>& sets, std::size_t row) {
    std::set<float> values;
    for (const ParameterSet& set : sets) values.insert(set.rows[row][0]);
    return values;
}

}  // namespace

TEST(LabParameterSweep, CoversRangesAndChoices) {
    const BrdfTable model = parse_brdf_table("glossy.h", table);
    const auto sets = parameter_sweep(model, 1000);
    EXPECT_EQ(sets[0].text, "defaults");
    EXPECT_EQ(sets[0].rows, model.default_rows());
    const std::set<float> n = values_of(sets, 1);
    for (const float v : {0.0f, 1.0f, 100.0f, 1e6f}) EXPECT_TRUE(n.count(v)) << v;
    const std::set<float> rough = values_of(sets, 2);
    EXPECT_EQ(*rough.begin(), 0.01f);
    EXPECT_EQ(*rough.rbegin(), 2.0f);
    EXPECT_GE(rough.size(), 5u);
    EXPECT_EQ(values_of(sets, 3), (std::set<float>{1, 2, 3, 4}));
    EXPECT_EQ(values_of(sets, 4), (std::set<float>{0, 1, 2}));
    std::set<std::string> texts;
    for (const ParameterSet& set : sets) {
        EXPECT_TRUE(texts.insert(set.text).second) << set.text << " comes twice";
        for (std::size_t i = 0; i < set.rows.size(); ++i) {
            EXPECT_GE(set.rows[i][0], static_cast<float>(model.parameters[i].lowest));
            EXPECT_LE(set.rows[i][0], model.parameters[i].highest);
        }
    }
}

TEST(LabParameterSweep, FewSetsKeepTheDefaults) {
    const auto sets = parameter_sweep(parse_brdf_table("glossy.h", table), 7);
    EXPECT_EQ(sets.size(), 7u);
    EXPECT_EQ(sets[0].text, "defaults");
}

TEST(LabParameterSweep, ExtremesReachTheEndsOfFloat) {
    const auto sets = extreme_parameters(parse_brdf_table("glossy.h", table));
    const std::set<float> n = values_of(sets, 1);
    EXPECT_TRUE(n.count(HUGE_VALF));
    EXPECT_TRUE(n.count(3e38f));
    EXPECT_TRUE(n.count(0));
    EXPECT_TRUE(std::any_of(n.begin(), n.end(), [](float v) { return v > 0 && v < 1e-37f; }));
    EXPECT_EQ(*values_of(sets, 2).rbegin(), 2.0f) << "no further than the table permits";
}

TEST(LabParameterSweep, ShortNumbers) {
    EXPECT_EQ(short_number(0.25), "0.25");
    EXPECT_EQ(short_number(1e6), "1e+06");
}
