// SPDX-License-Identifier: Apache-2.0
// Tables of measured reflectance: both file layouts, every fault in them, and materials of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/files.h"
#include "base/kernel_text.h"
#include "base/random.h"
#include "scene/measured_files.h"
#include "scene_test_support.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double pi = 3.14159265358979323846;

MeasuredBrdf random_table(std::array<std::uint32_t, 3> counts) {
    Random random(3);
    MeasuredBrdf table{counts, {}};
    for (std::uint32_t i = 0; i < counts[0] * counts[1] * counts[2]; ++i)
        table.values.emplace_back(random.log_uniform(1e-4, 1e4), random.uniform(),
                                  random.uniform());
    return table;
}

MeasuredBrdf constant_table(std::array<std::uint32_t, 3> counts, float value) {
    MeasuredBrdf table{counts, {}};
    table.values.assign(std::size_t{counts[0]} * counts[1] * counts[2], glm::vec3(value));
    return table;
}

std::string merl(std::array<std::int32_t, 3> counts, const std::vector<double>& numbers) {
    std::string bytes(reinterpret_cast<const char*>(counts.data()), sizeof counts);
    return bytes.append(reinterpret_cast<const char*>(numbers.data()),
                        numbers.size() * sizeof(double));
}

// "LINE:COL: what" of the fault that reading these bytes ends in.
std::string fault_in(const std::string& bytes) {
    const TempFolder folder;
    const std::string path = folder.write("table", bytes);
    try {
        read_measured(path);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::scene);
        EXPECT_EQ(error.where().substr(0, path.size()), path);
        return error.where().substr(path.size()) + ": " + error.what();
    }
    return "none";
}

const std::vector<BrdfTable>& kernel_models() {
    static const std::vector<BrdfTable> tables = read_brdf_tables(KernelText());
    return tables;
}

// Reads a scene beside a table file of the given bytes.
Scene read_beside(const std::string& table, const std::string& world) {
    const TempFolder folder;
    folder.write("table.txt", table);
    folder.write("other.txt", table);
    return read_scene(folder.write("s.pbrt", world4(world)), kernel_models());
}

std::uint32_t index_of(const Material& material) {
    std::uint32_t index;
    std::memcpy(&index, &material.rows[0][0], sizeof index);
    return index;
}

const std::string one_cell = "brdf 1 1 1  0.1 0.2 0.3\n";

}  // namespace

// Where a direction pair belongs by the formulas of the layout's source.
TEST(Measured, CellsLieWhereTheLayoutSays) {
    const MeasuredBrdf table = constant_table({90, 90, 180}, 0);
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const std::size_t cell = random.below(90 * 90 * 180);
        const auto [wo, wi] = directions_at(table, cell);
        EXPECT_NEAR(glm::length(wo), 1, 1e-12);
        EXPECT_NEAR(glm::length(wi), 1, 1e-12);
        const glm::dvec3 h = glm::normalize(wo + wi);
        const double theta_h = std::atan2(std::hypot(h.x, h.y), h.z);
        const double theta_d = std::atan2(glm::length(wi - wo), glm::length(wi + wo));
        // wi with the half vector turned onto the normal
        const double x = h.z * wi.x - h.x * wi.z, phi_d = std::fmod(std::atan2(wi.y, x) + pi, pi);
        const auto at = static_cast<std::size_t>(std::sqrt(theta_h / (pi / 2)) * 90);
        const auto d = static_cast<std::size_t>(theta_d / (pi / 2) * 90);
        const auto phi = static_cast<std::size_t>(phi_d / pi * 180);
        EXPECT_EQ((at * 90 + d) * 180 + phi, cell);
    }
}

TEST(Measured, BinaryFilesAreRead) {
    const TempFolder folder;
    const MeasuredBrdf table = read_measured(
        folder.write("t", merl({1, 1, 2}, {1500, 3000, 1500 / 1.15, -1, 1500 / 1.66, 0})));
    EXPECT_EQ(table.counts, (std::array<std::uint32_t, 3>{1, 1, 2}));
    ASSERT_EQ(table.cells(), 2u);
    EXPECT_EQ(table.values[0], glm::vec3(1, 1, 1));
    EXPECT_TRUE(std::isnan(table.values[1].x));  // one channel has no data
}

TEST(Measured, WhatIsWrittenReadsBack) {
    const TempFolder folder;
    MeasuredBrdf table = random_table({5, 3, 4});
    table.values[17] = glm::vec3(NAN);
    write_merl(folder.file("m"), table);
    write_measured_text(folder.file("t"), table);
    EXPECT_EQ(read_file(folder.file("m")).size(), 12 + 8 * 3 * 60u);
    for (const char* name : {"m", "t"}) {
        const MeasuredBrdf back = read_measured(folder.file(name));
        EXPECT_EQ(back.counts, table.counts);
        for (std::size_t cell = 0; cell < table.cells(); ++cell)
            EXPECT_TRUE(cell == 17 ? std::isnan(back.values[cell].x)
                                   : back.values[cell] == table.values[cell])
                << name << " " << cell;
    }
}

TEST(Measured, TextIsRead) {
    const TempFolder folder;
    const MeasuredBrdf table = read_measured(folder.write(
        "t", "# made by hand\r\nbrdf 1 2 1 # counts\n\n 1e-3\t2 3#r g b\n-1 0 0\n# end"));
    EXPECT_EQ(table.counts, (std::array<std::uint32_t, 3>{1, 2, 1}));
    EXPECT_EQ(table.values[0], glm::vec3(1e-3f, 2, 3));
    EXPECT_TRUE(std::isnan(table.values[1].x));
}

TEST(Measured, FaultsOfBinaryFiles) {
    const std::vector<double> three(3, 1.0);
    EXPECT_EQ(fault_in(merl({1, 1, 1}, three)), "none");
    EXPECT_EQ(fault_in(std::string("\1\0\0", 3)), ": the file ends within its first three numbers");
    EXPECT_EQ(fault_in(merl({1, 1, 2}, three)),
              ": a table of 1 x 1 x 2 cells has 60 bytes, the file 36");
    EXPECT_EQ(fault_in(merl({1, 1, 1}, {1, 1, 1, 1})),
              ": a table of 1 x 1 x 1 cells has 36 bytes, the file 44");
    EXPECT_EQ(fault_in(merl({1, 1, 1}, three) + "x"),
              ": a table of 1 x 1 x 1 cells has 36 bytes, the file 37");
    const char* const along = " cells along an axis; it may have 1 to 4096";
    for (const int count : {0, -1, 4097, 2000000000})
        EXPECT_EQ(fault_in(merl({1, count, 1}, three)),
                  ": the table has " + std::to_string(count) + along);
    EXPECT_EQ(fault_in(merl({4096, 4096, 4096}, three)),
              ": the table has 68719476736 cells; it may have 33554432");
    EXPECT_EQ(fault_in(merl({90, 90, 180}, three)),
              ": a table of 90 x 90 x 180 cells has 34992012 bytes, the file 36");
    for (const double bad : {HUGE_VAL, -HUGE_VAL, double(NAN)})
        EXPECT_EQ(fault_in(merl({1, 1, 1}, {1, 1, bad})), ": a value is not finite (cell 0)");
    EXPECT_EQ(fault_in(merl({1, 1, 2}, {1, 1, 1, 1e40, 1, 1})),
              ": the value 7.66666667e+36 is too large (cell 1)");
}

TEST(Measured, FaultsOfText) {
    EXPECT_EQ(fault_in(one_cell), "none");
    EXPECT_EQ(fault_in(""), ":1:1: this is no table of reflectance");
    EXPECT_EQ(fault_in("# c\n BRDF 1 1 1 0 0 0"), ":2:2: this is no table of reflectance");
    EXPECT_EQ(fault_in("brdf 1 1"), ":1:9: the file ends where a count of cells should be");
    EXPECT_EQ(fault_in("brdf 1 1.5 1 0 0 0"), ":1:8: '1.5' is not a count of cells");
    EXPECT_EQ(fault_in("brdf 1 0 1 0 0 0"),
              ":1:8: the table has 0 cells along an axis; it may have 1 to 4096");
    EXPECT_EQ(fault_in("brdf 4000 4000 4000 0"),
              ":1:16: the table has 64000000000 cells; it may have 33554432");
    EXPECT_EQ(fault_in("brdf 100 100 100 0 0 0"),
              ":1:14: the file is too short for the cells that it announces");
    EXPECT_EQ(fault_in("brdf 1 1 1\n0 zero 0"), ":2:3: 'zero' is not a number");
    EXPECT_EQ(fault_in("brdf 1 1 1\n0 1e999 0"), ":2:3: '1e999' is not a number");
    EXPECT_EQ(fault_in("brdf 1 1 1\n0 0 nan"), ":2:5: a value is not finite");
    EXPECT_EQ(fault_in("brdf 1 1 1\n0 0 2e30"), ":2:5: the value 2e+30 is too large");
    EXPECT_EQ(fault_in("brdf 1 1 2\n0 0 0\n0 0"), ":3:4: the file ends where a number should be");
    EXPECT_EQ(fault_in(one_cell + "4"), ":2:1: there is more after the last of 1 x 1 x 1 cells");
    EXPECT_EQ(fault_in(one_cell + std::string("\0", 1) + "4"), ":2:1: a NUL byte in a scene file");
}

TEST(Measured, FilesOfOtherKindsAreRefusedByName) {
    EXPECT_NE(fault_in(std::string("tensor_file\0\1\0", 14)).find("tensor files (.bsdf)"),
              std::string::npos);
}

TEST(Measured, GapsTakeTheirNeighboursValues) {
    MeasuredBrdf table = constant_table({3, 2, 4}, 2);
    table.values[5] = table.values[6] = glm::vec3(NAN);
    fill_gaps(table, "t");
    for (const glm::vec3& value : table.values) EXPECT_EQ(value, glm::vec3(2));
    MeasuredBrdf lone = constant_table({20, 20, 20}, NAN);
    lone.values[4321] = glm::vec3(7);
    fill_gaps(lone, "t");
    for (const glm::vec3& value : lone.values) EXPECT_EQ(value, glm::vec3(7));
    // phi_d is periodic: the last cell lies beside the first.
    MeasuredBrdf row = constant_table({1, 1, 4}, 0);
    row.values = {glm::vec3(1), glm::vec3(0), glm::vec3(3), glm::vec3(NAN)};
    fill_gaps(row, "t");
    EXPECT_EQ(row.values[3], glm::vec3(2));
    MeasuredBrdf none = constant_table({2, 2, 2}, NAN);
    EXPECT_THROW(fill_gaps(none, "t"), Error);
}

TEST(Measured, AlbedoOfAConstantIsPiTimesIt) {
    EXPECT_NEAR(largest_albedo(constant_table({30, 4, 4}, 0.25f)), pi / 4, 2e-3);
    EXPECT_EQ(largest_albedo(constant_table({1, 1, 1}, 0)), 0);
}

TEST(Measured, TheSamplingDensityIntegratesToOne) {
    for (const MeasuredBrdf& table : {random_table({90, 4, 4}), constant_table({1, 1, 1}, 0),
                                      constant_table({7, 2, 3}, 0.3f), made_up_material()}) {
        const std::vector<float> laid = lay_out(table);
        const std::size_t nodes = table.counts[0] + 2;
        ASSERT_EQ(laid.size(), 4 + 3 * nodes + 3 * table.cells());
        EXPECT_EQ(laid[0], static_cast<float>(table.counts[0]));
        EXPECT_GE(laid[3], 0.1f);
        EXPECT_LE(laid[3], 1);
        double sum = 0;
        for (std::size_t i = 0; i + 1 < nodes; ++i) {
            const float *a = &laid[4 + 3 * i], *b = a + 3;
            EXPECT_NEAR(a[2], sum, 1e-6);
            EXPECT_GT(b[0], a[0]);
            const double at = (static_cast<double>(i) - 0.5) / table.counts[0];
            if (i > 0) {
                EXPECT_NEAR(a[0], 1 - std::cos(pi / 2 * at * at), 1e-7);
            }
            EXPECT_GE(a[1], 0);
            sum += 0.5 * (a[1] + b[1]) * (b[0] - a[0]);
        }
        EXPECT_NEAR(sum, 1, 1e-5);
        EXPECT_EQ(laid[4], 0);
        EXPECT_EQ(laid[4 + 3 * nodes - 3], 1);
    }
    EXPECT_EQ(lay_out(constant_table({7, 2, 3}, 0.3f))[3], 1);  // nothing above a diffuse part
}

TEST(Measured, MaterialsNameTheirFile) {
    const Scene scene = read_beside(one_cell,
                                    "Material \"measured\" \"string filename\" \"table.txt\"\n"
                                    "Shape \"sphere\"\n"
                                    "Material \"measured\" \"string filename\" \"other.txt\" "
                                    "\"rgb scale\" [1 2 3]\nShape \"sphere\"\n"
                                    "Material \"measured\" \"string filename\" \"./table.txt\"\n"
                                    "Shape \"sphere\"");
    ASSERT_EQ(scene.materials.size(), 3u);
    const auto one = static_cast<std::uint32_t>(lay_out(constant_table({1, 1, 1}, 1)).size());
    EXPECT_EQ(scene.tables.size(), 2 * one);
    EXPECT_EQ(index_of(scene.materials[0]), 0u);
    EXPECT_EQ(index_of(scene.materials[1]), one);
    EXPECT_EQ(index_of(scene.materials[2]), 0u);  // a file is read once
    EXPECT_EQ(scene.materials[1].rows[1], (std::array<float, 4>{1, 2, 3, 0}));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Measured, TheHashOfASceneKnowsItsTables) {
    const std::string world =
        "Material \"measured\" \"string filename\" \"table.txt\" Shape \"sphere\"";
    const std::string hash = read_beside(one_cell, world).hash;
    EXPECT_EQ(read_beside("# a comment\n" + one_cell, world).hash, hash);
    EXPECT_NE(read_beside("brdf 1 1 1  0.1 0.2 0.4\n", world).hash, hash);
}

TEST(Measured, WhatIsDoubtfulIsTold) {
    const std::string world =
        "Material \"measured\" \"string filename\" \"table.txt\" Shape \"sphere\"";
    const Scene bright = read_beside("brdf 1 1 1  0.4 0.2 0.3\n", world);
    ASSERT_EQ(bright.warnings.size(), 1u);
    EXPECT_NE(bright.warnings[0].find(":2:39: the table reflects up to 1.257 times"),
              std::string::npos)
        << bright.warnings[0];
    const Scene gaps = read_beside("brdf 1 2 1  .1 .1 .1 -1 -1 -1\n", world);
    ASSERT_EQ(gaps.warnings.size(), 1u);
    EXPECT_NE(gaps.warnings[0].find("1 of 2 cells above the horizon have no data"),
              std::string::npos)
        << gaps.warnings[0];
}

TEST(Measured, FaultsOfMaterials) {
    const auto fault = [](const std::string& world) -> std::string {
        try {
            read_beside(one_cell, world);
        } catch (const Error& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(fault("Material \"measured\" Shape \"sphere\""),
              "material \"measured\" lacks its parameter \"filename\"");
    EXPECT_EQ(fault("Material \"measured\" \"float filename\" 3"),
              "parameter \"filename\" wants one string, has float");
    EXPECT_EQ(fault("Material \"measured\" \"string filename\" \"none.txt\""),
              "no file 'none.txt'");
    EXPECT_EQ(fault("Material \"measured\" \"string filename\" \"s.pbrt\""),
              "this is no table of reflectance");
    EXPECT_EQ(
        fault("Material \"measured\" \"string filename\" \"table.txt\" \"rgb scale\" [1 1 -1]"),
        "parameter \"scale\" of material \"measured\" wants a value from 0 to 1000, has -1");
    const TempFolder folder;
    const std::string path = folder.write("s.pbrt", world4("Shape \"sphere\""));
    ReadOptions options;
    options.replace = {{"diffuse", "measured"}};
    EXPECT_THROW(read_scene(path, kernel_models(), options), Error);
}
