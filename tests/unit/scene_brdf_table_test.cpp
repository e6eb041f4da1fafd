// SPDX-License-Identifier: Apache-2.0
#include "scene/brdf_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/kernel_text.h"

using namespace lobe;

namespace {

std::string fault(const std::string& rows) {
    try {
        parse_brdf_table("brdf/x.h", "// x\n#define x_parameters(P) \\\n" + rows + "\n\nnext\n");
    } catch (const Error& error) {
        return error.where() + ": " + error.what();
    }
    return "";
}

}  // namespace

TEST(BrdfTable, ReadsRows) {
    const BrdfTable table = parse_brdf_table(
        "brdf/velvet.h",
        "// A parameter table NAME_parameters(P) of rows\n#define velvet_parameters(P) \\\n"
        "    P(color, kd, 0.25, 0, inf, \"diffuse part, 1/sr\") \\\n"
        "    P(number,n,100, 0,1e4,\"exponent (of: it)\") \\\r\n"
        "    P(integer, order, -2, -3, 8, \"order\") \\\n"
        "    P(choice, lobe, 1, 0, 2, \\\n       \"clamp|abs|listing: reading of cos phi\")\n"
        "#define other_parameters(P) P(color)\n");
    EXPECT_EQ(table.name, "velvet");
    EXPECT_EQ(table.file, "brdf/velvet.h");
    ASSERT_EQ(table.parameters.size(), 4u);
    const BrdfParameter& kd = table.parameters[0];
    EXPECT_EQ(kd.kind, BrdfParameterKind::color);
    EXPECT_EQ(kd.standard, .25);
    EXPECT_EQ(kd.highest, std::numeric_limits<double>::infinity());
    EXPECT_EQ(kd.meaning, "diffuse part, 1/sr");
    EXPECT_EQ(table.parameters[1].highest, 1e4);
    EXPECT_TRUE(table.parameters[1].choices.empty());
    EXPECT_EQ(table.parameters[2].lowest, -3);
    EXPECT_EQ(table.parameters[3].choices, (std::vector<std::string>{"clamp", "abs", "listing"}));
    EXPECT_EQ(table.find("order"), 2);
    EXPECT_EQ(table.find("Order"), -1);
    const auto rows = table.default_rows();
    EXPECT_EQ(rows[0], (std::array<float, 4>{.25f, .25f, .25f, 0}));
    EXPECT_EQ(rows[2], (std::array<float, 4>{-2, 0, 0, 0}));
    EXPECT_EQ(rows[3], (std::array<float, 4>{1, 0, 0, 0}));
}

TEST(BrdfTable, SaysWhichLineIsWrong) {
    EXPECT_EQ(fault("P(color, kd, 0.25, 0, inf, \"\") \\\n P(colour, ks, 0, 0, 1, \"\")"),
              "brdf/x.h:4:2: a row of x_parameters is malformed");
    EXPECT_EQ(fault("P(number, n, 1, 0, inf)"), "brdf/x.h:3:1: a row of x_parameters is malformed");
    EXPECT_EQ(fault("P(number, n, 1, 0, 2, \"\"), P(number, m, 1, 0, 2, \"\")"),
              "brdf/x.h:3:26: a row of x_parameters is malformed");
    EXPECT_EQ(fault("P(number, n, 3, 0, 2, \"\")"),
              "brdf/x.h:3:1: the default lies outside its range (x's n)");
    EXPECT_EQ(fault("P(number, n, one, 0, 2, \"\")"),
              "brdf/x.h:3:1: default and bounds must be numbers (x's n)");
    EXPECT_EQ(fault("P(number, n, 1, 0, 2, \"\") \\\n\tP(number, n, 1, 0, 2, \"\")"),
              "brdf/x.h:4:2: the name comes twice (x's n)");
    EXPECT_EQ(fault("P(integer, n, 1.5, 0, 2, \"\")"),
              "brdf/x.h:3:1: the default of an integer is no whole number (x's n)");
    EXPECT_EQ(fault("P(choice, n, 0, 0, 2, \"a|b: x\")"),
              "brdf/x.h:3:1: the bounds of a choice are 0 and the number of its last name (x's n)");
    EXPECT_NE(fault("P(choice, n, 0, 0, 1, \"a or b\")"), "");
    EXPECT_THROW(parse_brdf_table("brdf/x.h", "int x;"), Error);
}

TEST(BrdfTable, ReadsAddedModels) {
    KernelText kernels;
    kernels.add("dir/velvet.cl", "#define velvet_parameters(P) \\\nP(number, n, 1, 0, 2, \"\")\n");
    kernels.add("noise.h", "no model");
    std::size_t own = 0;
    for (const BrdfTable& table : read_brdf_tables(kernels)) {
        own += table.own;
        if (table.own) {
            EXPECT_EQ(table.name + " " + table.file, "velvet dir/velvet.cl");
        }
    }
    EXPECT_EQ(own, 1u);
    EXPECT_EQ(read_brdf_tables(kernels).size(), read_brdf_tables(KernelText()).size() + 1);
}

TEST(BrdfTable, ReadsAllModelsOfTheKernels) {
    const auto tables = read_brdf_tables(KernelText(std::string(LOBE_SOURCE_DIR) + "/kernels"));
    std::vector<std::string> names;
    for (const BrdfTable& table : tables) names.push_back(table.name);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const char* model :
         {"conductor", "lambert", "mirror", "modified_phong", "phong", "plastic", "rational"})
        EXPECT_NE(std::find(names.begin(), names.end(), model), names.end()) << model;
}
