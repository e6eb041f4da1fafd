// SPDX-License-Identifier: Apache-2.0
// Models of the user's own: their files, and scenes that name them.
#include "scene/user_model.h"

#include "base/files.h"
#include "scene_test_support.h"

using namespace lobe;
using namespace lobe::test;

namespace {

std::string model_text(const std::string& name) {
    return "// A test.\n#define " + name + "_parameters(P) \\\n" +
           "    P(color, kd, 0.25, 0, inf, \"\") \\\n    P(number, n, 4, 1, 50, \"\")\n";
}

// "FILE:LINE:COL: what", without the folder.
std::string fault(const TempFolder& folder, const std::string& file) {
    try {
        read_user_model(file, models());
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::scene);
        const std::size_t length = folder.path().size() + 1;
        return error.where().substr(error.where().find(folder.path()) + length) + ": " +
               error.what();
    }
    return "";
}

class SceneModel : public testing::Test {
  protected:
    SceneModel() { folder_.write("models/velvet.cl", model_text("velvet")); }

    Scene read(const std::string& lines, const ReadOptions& options = {}) {
        return read_scene(folder_.write("s.pbrt", world4(lines)), models(), options);
    }
    // The place and words of the fault.
    std::string fault(const std::string& lines) {
        try {
            read(lines);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::scene);
            return error.where().substr(folder_.path().size() + 1) + ": " + error.what();
        }
        return "";
    }

    TempFolder folder_;
};

}  // namespace

TEST(UserModel, IsReadAsTyped) {
    const TempFolder folder;
    const std::string file = folder.write("velvet.cl", "\xef\xbb\xbf" + model_text("velvet"));
    const UserModel model = read_user_model(file, models());
    EXPECT_EQ(model.table.name, "velvet");
    EXPECT_EQ(model.table.file, file);
    EXPECT_TRUE(model.table.own);
    EXPECT_EQ(model.text, model_text("velvet"));
}

TEST(UserModel, ANameThatIsTakenIsRefused) {
    const TempFolder folder;
    const std::string file = folder.write("x.cl", model_text("modifiedphong"));
    EXPECT_EQ(fault(folder, file),
              "x.cl:2:9: the name 'modifiedphong' is taken by lobe's own brdf/modified_phong.h");
    folder.write("x.cl", model_text("matte"));
    EXPECT_EQ(fault(folder, file), "x.cl:2:9: the name 'matte' is taken by a material of pbrt");
}

TEST(UserModel, FaultsHaveTheirPlace) {
    const TempFolder folder;
    const std::string file = folder.write("x.cl", "int x;\n");
    EXPECT_EQ(fault(folder, file), "x.cl:1:1: no table NAME_parameters(P) with its rows");
    folder.write("x.cl", std::string("a\0b", 3));
    EXPECT_EQ(fault(folder, file), "x.cl: a kernel is plain text, and this file has a NUL byte");
    std::string text = model_text("x");
    folder.write("x.cl", text.replace(text.find("4, 1"), 1, "0"));
    EXPECT_EQ(fault(folder, file), "x.cl:4:5: the default lies outside its range (x's n)");
    EXPECT_NE(fault(folder, folder.write("a\"b.cl", text)), "");
}

TEST(UserModel, IsFoundHoweverItIsNamed) {
    const TempFolder folder;
    folder.write("models/velvet.cl", model_text("velvet"));
    std::vector<BrdfTable> tables = models();
    tables.push_back(read_user_model(folder.file("models/velvet.cl"), tables).table);
    EXPECT_EQ(find_user_model(tables, folder.file("models/../models/velvet.cl")), &tables.back());
    EXPECT_EQ(find_user_model(tables, folder.file("other.cl")), nullptr);
    EXPECT_EQ(find_user_model(tables, "brdf/lambert.h"), nullptr) << "that is lobe's";
}

// The material's type may be anything; its parameters are those of the file's table.
TEST_F(SceneModel, IsReadOnceForAllItsMaterials) {
    const Scene scene = read(R"(
        Material "cloth" "string brdf" "models/velvet.cl" "rgb kd" [.1 .2 .3] "float n" 7
        Shape "sphere"
        MakeNamedMaterial "a" "string type" "plastic" "string brdf" "./models/velvet.cl"
        MakeNamedMaterial "b" "string brdf" "models/velvet.cl"
        NamedMaterial "a" Shape "sphere" NamedMaterial "b" Shape "sphere")");
    ASSERT_EQ(scene.models.size(), 1u);
    EXPECT_EQ(scene.models[0].table.file, folder_.file("models/velvet.cl"));
    EXPECT_EQ(scene.models[0].text, model_text("velvet"));
    EXPECT_EQ(scene.models[0].where, folder_.file("s.pbrt") + ":3:40");
    ASSERT_EQ(scene.materials.size(), 3u);
    for (const Material& material : scene.materials) EXPECT_EQ(material.brdf, "velvet");
    EXPECT_EQ(scene.materials[0].type, "cloth");
    EXPECT_FLOAT_EQ(scene.materials[0].rows.at(0)[1], .2f);
    EXPECT_FLOAT_EQ(scene.materials[0].rows.at(1)[0], 7);
    EXPECT_FLOAT_EQ(scene.materials[1].rows.at(1)[0], 4);
}

TEST_F(SceneModel, OneThatIsGivenServes) {
    std::vector<BrdfTable> tables = models();
    tables.push_back(read_user_model(folder_.file("models/velvet.cl"), tables).table);
    const std::string lines =
        "Material \"x\" \"string brdf\" \"models/velvet.cl\" Shape \"sphere\"\n"
        "Material \"velvet\" \"float n\" 3 Shape \"sphere\"";
    const Scene scene = read_scene(folder_.write("s.pbrt", world4(lines)), tables);
    EXPECT_TRUE(scene.models.empty());
    EXPECT_EQ(scene.materials.at(0).brdf, "velvet");
    EXPECT_EQ(scene.materials.at(1).brdf, "velvet");
}

TEST_F(SceneModel, FaultsHaveTheirPlace) {
    const std::string cloth = "Material \"cloth\" \"string brdf\" \"models/velvet.cl\" ";
    EXPECT_EQ(fault("Material \"x\" \"string brdf\" \"none.cl\" Shape \"sphere\""),
              "s.pbrt:2:28: no file 'none.cl'");
    EXPECT_EQ(fault("Material \"x\" \"float brdf\" 3 Shape \"sphere\""),
              "s.pbrt:2:14: parameter \"brdf\" of material \"x\" wants one string, has float");
    EXPECT_EQ(fault(cloth + "\"float n\" 51 Shape \"sphere\""),
              "s.pbrt:2:51: parameter \"n\" of material \"cloth\" wants a value from 1 to 50, has "
              "51");
    EXPECT_EQ(fault(cloth + "\"float m\" 5 Shape \"sphere\""),
              "s.pbrt:2:51: unknown parameter \"m\" of material \"cloth\"");
    folder_.write("other/velvet.cl", model_text("velvet"));
    const std::string both =
        fault(cloth + "Material \"x\" \"string brdf\" \"other/velvet.cl\" Shape \"sphere\"");
    EXPECT_EQ(both.find("other/velvet.cl:2:9: the name 'velvet' is taken by the model of "), 0u)
        << both;
}

TEST_F(SceneModel, UnusedOnesAreLeftOutAndTextsCount) {
    const std::string unused =
        "Material \"x\" \"string brdf\" \"models/velvet.cl\" "
        "Material \"diffuse\" Shape \"sphere\"";
    EXPECT_TRUE(read(unused).models.empty());
    const std::string used = "Material \"x\" \"string brdf\" \"models/velvet.cl\" Shape \"sphere\"";
    const std::string hash = read(used).hash;
    folder_.write("models/velvet.cl", model_text("velvet") + "// changed\n");
    EXPECT_NE(read(used).hash, hash);
}

// n of the model that takes over is in that model's range, or told.
TEST_F(SceneModel, ReplaceKeepsToTheTable) {
    std::vector<BrdfTable> tables = models();
    tables.push_back(read_user_model(folder_.file("models/velvet.cl"), tables).table);
    ReadOptions options;
    options.replace = {{"plastic", "velvet"}};
    const auto replaced = [&](const std::string& line) {
        return read_scene(folder_.write("s.pbrt", world3(line + " Shape \"sphere\"")), tables,
                          options)
            .materials.at(0);
    };
    EXPECT_EQ(replaced("Material \"plastic\"").brdf, "velvet");
    EXPECT_FLOAT_EQ(replaced("Material \"plastic\"").rows.at(1)[0], 4);
    options.replace_n = 20;
    EXPECT_FLOAT_EQ(replaced("Material \"plastic\"").rows.at(1)[0], 20);
    options.replace_n = 100;
    EXPECT_THROW(replaced("Material \"plastic\""), Error);
    options = {};
    options.replace = {{"modifiedphong", "velvet"}};
    EXPECT_THROW(replaced("Material \"modifiedphong\" \"float n\" 1000"), Error);
}
