// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "scene_test_support.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double pi = 3.14159265358979323846;

Material material3(const std::string& line) {
    return read_text(world3(line + " Shape \"sphere\"")).materials.at(0);
}
Material material4(const std::string& line) {
    return read_text(world4(line + " Shape \"sphere\"")).materials.at(0);
}

void expect_row(const Material& material, std::size_t row, double x, double y, double z) {
    EXPECT_NEAR(material.rows.at(row)[0], x, 1e-6 * (1 + std::fabs(x)));
    EXPECT_NEAR(material.rows.at(row)[1], y, 1e-6 * (1 + std::fabs(y)));
    EXPECT_NEAR(material.rows.at(row)[2], z, 1e-6 * (1 + std::fabs(z)));
}

// pbrt-v3's fit, term by term.
double v3_alpha(double roughness) {
    const double x = std::log(roughness);
    return 1.62142 + 0.819955 * x + 0.1734 * x * x + 0.0171201 * x * x * x +
           0.000640711 * x * x * x * x;
}

}  // namespace

TEST(Materials, MatteAndDiffuseAreLambert) {
    const Material matte = material3("Material \"matte\" \"rgb Kd\" [.1 .2 .3]");
    EXPECT_EQ(matte.brdf, "lambert");
    EXPECT_EQ(matte.type, "matte");
    expect_row(matte, 0, .1 / pi, .2 / pi, .3 / pi);
    expect_row(material3("Material \"matte\""), 0, .5 / pi, .5 / pi, .5 / pi);
    expect_row(material4("Material \"diffuse\" \"rgb reflectance\" [.1 .2 .3]"), 0, .1 / pi,
               .2 / pi, .3 / pi);
    expect_row(material4("Material \"diffuse\""), 0, .5 / pi, .5 / pi, .5 / pi);
    expect_row(material4(""), 0, .5 / pi, .5 / pi, .5 / pi);  // before the first Material
    EXPECT_EQ(fault_of(world3("Material \"matte\" \"float sigma\" 0")), "");
    const Material rough = material3("Material \"matte\" \"rgb Kd\" [.1 .2 .3] \"float sigma\" 20");
    EXPECT_EQ(rough.brdf, "oren_nayar");
    expect_row(rough, 0, .1 / pi, .2 / pi, .3 / pi);
    expect_row(rough, 1, 20, 0, 0);
    EXPECT_FAULT(world3("Material \"matte\" \"float sigma\" 91"), "2:18", "from 0 to 90");
}

TEST(Materials, Plastic) {
    const Material plastic = material3(
        "Material \"plastic\" \"color Kd\" [.4 .2 .2] \"color Ks\" [.5 .5 .5] \"float roughness\" "
        ".025");
    EXPECT_EQ(plastic.brdf, "plastic");
    expect_row(plastic, 0, .4 / pi, .2 / pi, .2 / pi);
    expect_row(plastic, 1, .5, .5, .5);
    expect_row(plastic, 2, v3_alpha(.025), 0, 0);
    expect_row(plastic, 3, 1 / 1.5, 0, 0);  // pbrt-v3 has the indices the other way round
    const Material standard = material3("Material \"plastic\"");
    expect_row(standard, 0, .25 / pi, .25 / pi, .25 / pi);
    expect_row(standard, 1, .25, .25, .25);
    expect_row(standard, 2, v3_alpha(.1), 0, 0);
    expect_row(material3("Material \"plastic\" \"float roughness\" 0"), 2, v3_alpha(1e-3), 0, 0);
    expect_row(material3("Material \"plastic\" \"float roughness\" .3 \"bool remaproughness\" "
                         "\"false\""),
               2, .3, 0, 0);
}

TEST(Materials, MetalIsCopperOfVersion3) {
    const Material metal = material3("Material \"metal\"");
    EXPECT_EQ(metal.brdf, "conductor");
    expect_row(metal, 0, 0.200438, 0.924033, 1.102212);
    expect_row(metal, 1, 3.912949, 2.452848, 2.142188);
    expect_row(metal, 2, v3_alpha(.01), 0, 0);
    expect_row(metal, 3, v3_alpha(.01), 0, 0);
}

TEST(Materials, ConductorOfVersion4) {
    const Material smooth = material4("Material \"conductor\"");
    expect_row(smooth, 0, 0.200438, 0.924033, 1.102212);
    expect_row(smooth, 2, 0, 0, 0);
    const Material gold = material4(
        "Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" "
        "[\"metal-Au-k\"] \"float roughness\" .09 \"float vroughness\" .25");
    expect_row(gold, 0, 0.143119, 0.374957, 1.442479);
    expect_row(gold, 1, 3.983160, 2.385721, 1.603215);
    expect_row(gold, 2, .3, 0, 0);  // square roots
    expect_row(gold, 3, .5, 0, 0);
    expect_row(material4("Material \"conductor\" \"float roughness\" .09 \"bool remaproughness\" "
                         "false"),
               2, .09, 0, 0);
}

TEST(Materials, MetalOfVersion3ByTheNamesOfItsSpectra) {
    const Material gold = material3(
        "Material \"metal\" \"spectrum eta\" \"spds/Au.eta.spd\" \"spectrum k\" \"Au.k.spd\"");
    expect_row(gold, 0, 0.143119, 0.374957, 1.442479);
    expect_row(gold, 1, 3.983160, 2.385721, 1.603215);
}

TEST(Materials, ConductorOfAReflectanceReflectsThatMuch) {
    const Material m = material4("Material \"conductor\" \"rgb reflectance\" [.2 .5 1]");
    for (int i = 0; i < 3; ++i) {
        const double eta = m.rows[0][i], k = m.rows[1][i];
        const double r = ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
        EXPECT_NEAR(r, std::min(std::array{.2, .5, 1.}[i], .9999), 1e-6);
    }
    EXPECT_FAULT(world4("Material \"conductor\" \"rgb reflectance\" [1 1 1] \"rgb k\" [1 1 1]"),
                 "2:48", "either");
}

TEST(Materials, Mirror) {
    expect_row(material3("Material \"mirror\""), 0, .9, .9, .9);
    expect_row(material3("Material \"mirror\" \"rgb Kr\" [1 .5 0]"), 0, 1, .5, 0);
}

TEST(Materials, OurModelsAreReadByTheirTables) {
    const Material phong = material4(
        "Material \"ModifiedPhong\" \"rgb ks\" [1 2 3] \"float kd\" .1 \"integer n\" 7 "
        "\"bool normalize\" true");
    EXPECT_EQ(phong.brdf, "modified_phong");
    EXPECT_EQ(phong.type, "ModifiedPhong");
    expect_row(phong, 0, .1, .1, .1);
    expect_row(phong, 1, 1, 2, 3);
    expect_row(phong, 2, 7, 0, 0);
    expect_row(phong, 3, 1, 0, 0);
    const Material test = material4(
        "Material \"testmodel\" \"string lobe\" \"listing\" "
        "\"integer order\" 3");
    expect_row(test, 0, .25, .25, .25);
    expect_row(test, 2, 3, 0, 0);
    expect_row(test, 3, 2, 0, 0);
    EXPECT_EQ(material4("Material \"modified_phong\" \"float n\" inf").rows[2][0],
              std::numeric_limits<float>::infinity());
}

TEST(Materials, ParametersOutOfRangeSayTheirRange) {
    EXPECT_FAULT(world4("Material \"modifiedphong\" \"float n\" -1"), "2:26",
                 "wants 0 or more, has -1");
    EXPECT_FAULT(world4("Material \"testmodel\" \"float n\" 1001"), "2:22",
                 "wants a value from 0 to 1000, has 1001");
    EXPECT_FAULT(world4("Material \"testmodel\" \"float n\" inf"), "2:32", "finite");
    EXPECT_FAULT(world4("Material \"testmodel\" \"rgb kd\" [0 -1 0]"), "2:22", "has -1");
    EXPECT_FAULT(world4("Material \"testmodel\" \"float order\" 2.5"), "2:36", "whole number");
    EXPECT_FAULT(world4("Material \"testmodel\" \"string lobe\" \"claMp\""), "2:36",
                 "did you mean 'clamp'? choose one of: clamp, abs, listing");
    EXPECT_FAULT(world4("Material \"modifiedphong\" \"float n\" 1e39"), "2:26", "too large");
    EXPECT_FAULT(world4("LightSource \"point\" \"rgb I\" [1e20 0 0] \"float scale\" 1e20"), "2:40",
                 "too large");
    EXPECT_FAULT(world3("Material \"matte\" \"rgb Kd\" [.5 -.5 .5]"), "2:18", "has -0.5");
}

TEST(Materials, UnknownNamesAreErrors) {
    EXPECT_FAULT(world3("Material \"mate\""), "2:10", "did you mean 'matte'");
    EXPECT_FAULT(world3("Material \"glass\""), "2:10", "understood but not supported yet");
    EXPECT_FAULT(world4("Material \"\""), "2:10", "understood but not supported yet");
    EXPECT_FAULT(world4("MakeNamedMaterial \"a\" \"string type\" \"coateddiffuse\""), "2:37",
                 "understood but not supported yet");
    EXPECT_FAULT(world4("MakeNamedMaterial \"a\""), "2:1", "lacks its parameter \"type\"");
    EXPECT_FAULT(world3("Material \"matte\"\n \"rgb Kb\" [1 1 1]"), "3:2",
                 "unknown parameter \"Kb\" of material \"matte\" | did you mean 'Kd'?");
    EXPECT_FAULT(world3("Material \"matte\" \"string Kd\" \"red\""), "2:18", "wants a colour");
    EXPECT_FAULT(world3("Material \"matte\" \"rgb Kd\" [1 1 1] \"rgb Kd\" [0 0 0]"), "2:35",
                 "given twice");
    EXPECT_FAULT(world3("Material \"matte\" \"texture bumpmap\" \"t\""), "2:18",
                 "understood but not supported yet");
}

TEST(Materials, ConstantTexturesAreValues) {
    expect_row(material3("Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [.1 .2 .3] "
                         "Material \"matte\" \"texture Kd\" \"t\""),
               0, .1 / pi, .2 / pi, .3 / pi);
    expect_row(material4("Texture \"t\" \"float\" \"constant\" \"float value\" 9 "
                         "Material \"testmodel\" \"texture n\" \"t\""),
               1, 9, 0, 0);
    EXPECT_FAULT(world3("Material \"matte\" \"texture Kd\" \"t\""), "2:31", "no texture");
    EXPECT_FAULT(world3("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"x.png\"\n"
                        "Material \"matte\" \"texture Kd\" \"t\""),
                 "3:31", "\"imagemap\", understood but not supported yet");
}

TEST(Materials, SpectraBecomeColours) {
    const auto kd = [](const std::string& value) {
        return material3("Material \"testmodel\" " + value).rows[0];
    };
    const auto grey = kd("\"spectrum kd\" [300 .5 900 .5]");
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(grey[i], .5, .11);  // a flat spectrum is not D65 white
    const auto xyz = kd("\"xyz kd\" [.9505 1 1.089]");
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(xyz[i], 1, 2e-3);
    const auto red = kd("\"blackbody kd\" [2000 1]");
    EXPECT_GT(red[0], 2 * red[1]);
    EXPECT_GT(red[1], red[2]);
    ReadOptions v3, v4;
    v3.dialect = Dialect::v3;
    v4.dialect = Dialect::v4;
    EXPECT_EQ(fault_of(world3("Material \"matte\" \"blackbody Kd\" [2000]"), v3),
              "2:18: a blackbody wants 2 numbers, has 1 | [ kelvin scale ] in version 3");
    EXPECT_EQ(fault_of(world4("Material \"diffuse\" \"blackbody reflectance\" [2000 1]"), v4),
              "2:20: a blackbody wants 1 number, has 2 | [ kelvin ] in version 4");
    EXPECT_FAULT(world3("Material \"metal\" \"spectrum eta\" \"spds/Zn.eta.spd\""), "2:33",
                 "spectrum files");
    EXPECT_FAULT(world4("Material \"conductor\" \"spectrum eta\" \"metal-Cu-ata\""), "2:37",
                 "did you mean 'metal-Cu-eta'");
    EXPECT_FAULT(world3("Material \"matte\" \"spectrum Kd\" [500 1 400 1]"), "2:39", "increase");
}

TEST(Materials, ReplaceTakesAnotherModel) {
    ReadOptions options;
    options.replace = {{"plastic", "modifiedphong"}, {"matte", "modified_phong"}};
    options.replace_n = 20;
    const Scene scene = read_text(
        world3("Material \"plastic\" \"rgb Kd\" [.1 .2 .3] \"rgb Ks\" [.4 .5 .6] Shape \"sphere\"\n"
               "Material \"matte\" \"rgb Kd\" [.1 .2 .3] Shape \"sphere\" "
               "Material \"mirror\" Shape \"sphere\""),
        options);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(scene.materials[i].brdf, "modified_phong");
        expect_row(scene.materials[i], 0, .1 / pi, .2 / pi, .3 / pi);
        expect_row(scene.materials[i], 2, 20, 0, 0);
    }
    EXPECT_EQ(scene.materials[0].type, "plastic");
    expect_row(scene.materials[0], 1, .4, .5, .6);
    expect_row(scene.materials[1], 1, 0, 0, 0);
    EXPECT_EQ(scene.materials[2].brdf, "mirror");
    options.replace = {{"mirror", "lambert"}};
    EXPECT_NE(fault_of(world3("Material \"mirror\""), options).find("2:1: --replace"),
              std::string::npos);
    options.replace = {{"uber", "lambert"}};
    EXPECT_EQ(read_text(world3("Shape \"sphere\""), options).warnings.size(), 1u);
    options.replace = {{"matte", "lambart"}};
    try {
        read_text(world3("Material \"matte\""), options);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_NE(error.hint().find("'lambert'"), std::string::npos);
    }
}
