// SPDX-License-Identifier: Apache-2.0
// Blocks, transforms, names, objects, includes and dialects.
#include <cmath>
#include <filesystem>

#include "scene_test_support.h"

using namespace lobe;
using namespace lobe::test;

namespace {

glm::dvec3 centre(const Scene& scene, std::size_t shape = 0) {
    return std::get<Sphere>(scene.shapes.at(shape).geometry).centre;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-12) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

constexpr const char* sphere = "Shape \"sphere\"\n";

}  // namespace

TEST(Reader, TransformsMultiplyFromTheRight) {
    const Scene scene =
        read_text(world4("Scale 2 2 2 Translate 1 0 0 Rotate 90 0 0 1 "
                         "Translate 1 0 0 Shape \"sphere\" \"float radius\" 3"));
    expect_near(centre(scene), {2, 2, 0});
    EXPECT_NEAR(std::get<Sphere>(scene.shapes[0].geometry).radius, 6, 1e-12);
}

TEST(Reader, MatricesStandInColumns) {
    const Scene scene = read_text(
        world4("Transform [1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1] ConcatTransform [1 0 0 0 0 1 0 0 0 0 "
               "1 0 1 1 1 1] Shape \"sphere\" Identity Shape \"sphere\""));
    expect_near(centre(scene, 0), {6, 7, 8});
    expect_near(centre(scene, 1), {0, 0, 0});
}

TEST(Reader, CameraLooksAlongItsAxis) {
    const Scene scene = read_text(
        "LookAt 1 2 3  4 2 3  0 0 1 Camera \"perspective\" \"float fov\" 39\n" + world4(""));
    const glm::dmat4& m = scene.camera.camera_to_world;
    expect_near(glm::dvec3(m[3]), {1, 2, 3});
    expect_near(glm::dvec3(m[2]), {1, 0, 0});  // forward
    expect_near(glm::dvec3(m[1]), {0, 0, 1});  // up
    expect_near(glm::dvec3(m[0]), {0, 1, 0});  // right: up x forward, left-handed
    EXPECT_EQ(scene.camera.fov, 39);
}

TEST(Reader, TransformBeforeLookAtActsInCameraSpace) {
    const Scene scene =
        read_text("Scale -1 1 1 LookAt 0 0 0  0 0 1  0 1 0 Camera \"perspective\"\n" + world4(""));
    EXPECT_LT(glm::determinant(glm::dmat3(scene.camera.camera_to_world)), 0);
}

TEST(Reader, CoordinateSystemsComeBackByName) {
    const Scene scene = read_text(
        "Translate 0 0 5 Camera \"perspective\"\n" +
        world4("Translate 1 2 3 CoordinateSystem \"here\" Identity CoordSysTransform \"here\" "
               "Shape \"sphere\" CoordSysTransform \"camera\" Shape \"sphere\" "
               "CoordSysTransform \"world\" Shape \"sphere\""));
    expect_near(centre(scene, 0), {1, 2, 3});
    expect_near(centre(scene, 1), {0, 0, -5});
    expect_near(centre(scene, 2), {0, 0, 0});
    EXPECT_FAULT(world4("CoordSysTransform \"camra\""), "2:19", "no coordinate system");
}

TEST(Reader, RefusesTransformsThatFlattenSpace) {
    EXPECT_FAULT(world4(" Scale 1 0 1"), "2:2", "degenerate");
    EXPECT_FAULT(world4("Scale 1 1 1e-31"), "2:1", "degenerate");
    EXPECT_EQ(fault_of(world4("Scale 1 1 1e-20")), "");
    EXPECT_EQ(fault_of(world4("Scale 1e-20 1e-20 1e-20")), "");
    EXPECT_FAULT(world4("Rotate 3 0 0 0"), "2:1", "axis");
    EXPECT_FAULT(world4("LookAt 1 1 1 1 1 1 0 1 0"), "2:1", "LookAt");
    EXPECT_FAULT(world4("LookAt 0 0 0 0 0 1 0 0 2"), "2:1", "LookAt");
    EXPECT_FAULT(world4("Transform [1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1]"), "2:1", "projective");
    EXPECT_FAULT(world4("Scale 1e200 1e200 1e200 Scale 1e200 1e200 1e200"), "2:25", "finite");
}

TEST(Reader, BlocksBringBackWhatTheySaved) {
    const Scene scene = read_text(world3(
        "Material \"mirror\" AttributeBegin Translate 1 0 0 Material \"matte\" ReverseOrientation\n"
        "AreaLightSource \"diffuse\" Shape \"sphere\" AttributeEnd Shape \"sphere\"\n"
        "TransformBegin Translate 0 1 0 Material \"matte\" TransformEnd Shape \"sphere\""));
    expect_near(centre(scene, 0), {1, 0, 0});
    EXPECT_TRUE(scene.shapes[0].flipped && scene.shapes[0].emission.has_value());
    expect_near(centre(scene, 1), {0, 0, 0});
    EXPECT_FALSE(scene.shapes[1].flipped || scene.shapes[1].emission.has_value());
    EXPECT_EQ(scene.materials[scene.shapes[1].material].brdf, "mirror");
    expect_near(centre(scene, 2), {0, 0, 0});
    EXPECT_EQ(scene.materials[scene.shapes[2].material].brdf, "lambert");
}

TEST(Reader, BlocksMustFit) {
    EXPECT_FAULT(world4("AttributeEnd"), "2:1", "AttributeEnd without AttributeBegin");
    EXPECT_FAULT(world4("AttributeBegin\n TransformEnd"), "3:2", "s.pbrt:2:1");
    EXPECT_FAULT(world4("AttributeBegin\n AttributeBegin AttributeEnd"), "2:1", "does not end");
    EXPECT_FAULT(world3("TransformBegin"), "3:1", "s.pbrt:2:1");
}

TEST(Reader, ManyNestedBlocksAreNoTrouble) {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "AttributeBegin ";
    for (int i = 0; i < 100000; ++i) text += "AttributeEnd ";
    EXPECT_EQ(fault_of(world4(text)), "");
}

TEST(Reader, DirectivesHaveTheirOrder) {
    EXPECT_FAULT("Shape \"sphere\"", "1:1", "before WorldBegin");
    EXPECT_FAULT(world4("Camera \"perspective\""), "2:1", "after WorldBegin");
    EXPECT_FAULT("Film \"rgb\"\n", "2:1", "no WorldBegin");
    EXPECT_FAULT(world4("WorldBegin"), "2:1", "second WorldBegin");
    EXPECT_FAULT(world3("") + "Shape \"sphere\"", "4:1", "after WorldEnd");
    EXPECT_FAULT("Film \"image\" WorldBegin\n", "2:1", "no WorldEnd");
}

TEST(Reader, NamedMaterialsCaptureWhatTheyMean) {
    const Scene scene = read_text(
        world3("MakeNamedMaterial \"a\" \"string type\" \"mirror\"\n"
               "NamedMaterial \"a\"\n" +
               std::string(sphere) + "MakeNamedMaterial \"a\" \"string type\" \"matte\"\n" +
               sphere + "NamedMaterial \"a\"\n" + sphere));
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.materials[scene.shapes[0].material].brdf, "mirror");
    EXPECT_EQ(scene.materials[scene.shapes[1].material].brdf, "mirror");
    EXPECT_EQ(scene.materials[scene.shapes[2].material].brdf, "lambert");
}

TEST(Reader, NamesLiveInTheirBlockInVersion3Only) {
    const std::string block =
        "AttributeBegin MakeNamedMaterial \"a\" \"string type\" \"mirror\" AttributeEnd\n"
        "NamedMaterial \"a\" Shape \"sphere\"";
    EXPECT_FAULT(world3(block), "3:15", "no material is called \"a\"");
    EXPECT_EQ(read_text("Film \"rgb\" WorldBegin " + block,
                        [] {
                            ReadOptions options;
                            options.dialect = Dialect::v4;
                            return options;
                        }())
                  .materials.at(0)
                  .brdf,
              "mirror");
}

TEST(Reader, Version4MayNameMaterialsFirst) {
    const Scene scene =
        read_text(world4("NamedMaterial \"late\" Shape \"sphere\"\n"
                         "MakeNamedMaterial \"late\" \"string type\" \"conductor\""));
    EXPECT_EQ(scene.materials.at(0).brdf, "conductor");
    EXPECT_FAULT(world4("NamedMaterial \"lost\""), "2:15", "no material is called \"lost\"");
}

TEST(Reader, UnusedMaterialsAreDropped) {
    const Scene scene =
        read_text(world3("Material \"mirror\" Material \"matte\" Shape \"sphere\""));
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].brdf, "lambert");
    EXPECT_EQ(scene.shapes[0].material, 0u);
}

TEST(Reader, InstancesAreCopiesThroughBothTransforms) {
    const Scene scene = read_text(
        world4("ObjectBegin \"o\" Translate 1 0 0 Shape \"sphere\" Shape \"trianglemesh\" "
               "\"point3 P\" [0 0 0 1 0 0 0 1 0] ObjectEnd\n"
               "AttributeBegin Scale 2 2 2 ObjectInstance \"o\" AttributeEnd\n"
               "Scale -1 1 1 ObjectInstance \"o\""));
    ASSERT_EQ(scene.shapes.size(), 4u);
    expect_near(centre(scene, 0), {2, 0, 0});
    expect_near(std::get<Mesh>(scene.shapes[1].geometry).positions[1], {4, 0, 0});
    EXPECT_FALSE(scene.shapes[1].flipped);
    expect_near(centre(scene, 2), {-1, 0, 0});
    EXPECT_FALSE(scene.shapes[2].flipped);
    EXPECT_TRUE(scene.shapes[3].flipped);
    EXPECT_FAULT(world4("ObjectInstance \"o\""), "2:16", "no object");
    EXPECT_FAULT(world4("ObjectBegin \"o\"\nAreaLightSource \"diffuse\" Shape \"sphere\""), "3:27",
                 "area light");
    EXPECT_FAULT(world4("ObjectBegin \"o\" ObjectInstance \"o\""), "2:17", "within an object");
    EXPECT_FAULT(world4("ObjectBegin \"o\" Shape \"sphere\" ObjectEnd Scale 1 2 1\n"
                        "ObjectInstance \"o\""),
                 "3:1", "stretched");
}

TEST(Reader, TakesTheStartOfMotion) {
    const Scene scene = read_text(
        world4("ActiveTransform EndTime Translate 5 0 0 ActiveTransform StartTime Translate 1 0 0 "
               "Shape \"sphere\""));
    expect_near(centre(scene), {1, 0, 0});
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("s.pbrt:2:1: motion"), std::string::npos);
}

TEST(Reader, TransformEndBringsBackWhichTransformIsActive) {
    const Scene scene =
        read_text(world4("TransformBegin ActiveTransform EndTime TransformEnd Translate 1 0 0 "
                         "Shape \"sphere\""));
    expect_near(centre(scene), {1, 0, 0});
}

TEST(Reader, RefusesWhatIsNotThereByName) {
    EXPECT_FAULT(world4("MakeNamedMedium \"m\""), "2:1", "not supported yet");
    EXPECT_FAULT(world4("MediumInterface \"fog\""), "2:1", "not supported yet");
    EXPECT_EQ(fault_of(world4("MediumInterface \"\" \"\"")), "");
    EXPECT_FAULT(world4("Attribute \"shape\" \"float radius\" 2"), "2:1", "not supported yet");
    EXPECT_FAULT(world4("ColorSpace \"rec2020\""), "2:12", "use srgb");
    EXPECT_FAULT(world4("ColorSpace \"srbg\""), "2:12", "did you mean 'srgb'");
}

TEST(Reader, LenientLeavesOutWhatIsUnknown) {
    ReadOptions options;
    options.lenient = true;
    const Scene scene = read_text(
        world4("Shine 3 \"x\" [1 2]\nShape \"cube\" \"float a\" 1\nMaterial \"diffuze\" "
               "\"rgb K\" [1 1 1]\nShape \"sphere\" \"float radios\" 2 \"flaot z\" [3 4]"),
        options);
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(scene.warnings.size(), 5u);
    EXPECT_EQ(scene.materials.at(0).brdf, "lambert");
    EXPECT_NE(fault_of(world4("MakeNamedMedium \"m\""), options), "");  // refused all the same
}

TEST(Dialect, IsFoundBySigns) {
    const auto dialect = [](const std::string& text) { return read_text(text).dialect; };
    EXPECT_EQ(dialect("WorldBegin WorldEnd"), Dialect::v3);
    EXPECT_EQ(dialect("WorldBegin"), Dialect::v4);
    EXPECT_EQ(dialect("PixelFilter \"box\" \"float xradius\" 1 WorldBegin"), Dialect::v4);
    EXPECT_EQ(dialect("Film \"image\" WorldBegin WorldEnd"), Dialect::v3);
}

TEST(Dialect, AmbiguousFilesNameTheOption) {
    const std::string both = "Film \"rgb\"\nWorldBegin\nWorldEnd\n";
    const std::string fault = fault_of(both);
    EXPECT_NE(fault.find("s.pbrt:1:6"), std::string::npos) << fault;
    EXPECT_NE(fault.find("s.pbrt:3:1"), std::string::npos) << fault;
    EXPECT_NE(fault.find("--dialect v3 or --dialect v4"), std::string::npos) << fault;
    ReadOptions options;
    options.dialect = Dialect::v3;
    EXPECT_EQ(read_text(both, options).filter.kind, FilterKind::box);
    options.dialect = Dialect::v4;
    EXPECT_EQ(read_text(both, options).filter.kind, FilterKind::gaussian);
}

TEST(Include, IsRelativeToTheIncludingFile) {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path() + "/a");
    folder.write("a/one.pbrt", "Include \"two.pbrt\"\n");
    folder.write("a/two.pbrt", "Translate 1 0 0 Shape \"sphere\" Include \"three.pbrt\"\n");
    folder.write("three.pbrt", "Shape \"sphere\"");  // beside the root, as pbrt looks for it
    const Scene scene = read_scene(
        folder.write("s.pbrt", world4("Include \"a/one.pbrt\" Include \"a/one.pbrt\"")), models());
    ASSERT_EQ(scene.shapes.size(), 4u);
    expect_near(centre(scene, 0), {1, 0, 0});
    expect_near(centre(scene, 3), {2, 0, 0});  // Include leaves its transforms behind
    EXPECT_NE(scene.shapes[0].where.find("a/two.pbrt:1:17"), std::string::npos);
}

TEST(Include, ImportKeepsItsStateToItself) {
    const TempFolder folder;
    folder.write("i.pbrt", "Translate 1 0 0 Material \"conductor\" Shape \"sphere\"");
    const Scene scene =
        read_scene(folder.write("s.pbrt", world4("Import \"i.pbrt\" Shape \"sphere\"")), models());
    expect_near(centre(scene, 0), {1, 0, 0});
    expect_near(centre(scene, 1), {0, 0, 0});
    EXPECT_EQ(scene.materials[scene.shapes[1].material].brdf, "lambert");
}

TEST(Include, RecursionAndDepthShowTheChain) {
    const TempFolder folder;
    folder.write("b.pbrt", "Include \"s.pbrt\"");
    const std::string root = folder.write("s.pbrt", world4("Include \"b.pbrt\""));
    for (int i = 0; i < 40; ++i)
        folder.write("d" + std::to_string(i) + ".pbrt",
                     "Include \"d" + std::to_string(i + 1) + ".pbrt\"");
    const auto fault = [&](const std::string& path) -> std::string {
        try {
            read_scene(path, models());
        } catch (const Error& error) {
            return error.where() + " " + error.what();
        }
        return "";
    };
    EXPECT_NE(fault(root).find("b.pbrt:1:9 a file that includes itself: " + root + " includes "),
              std::string::npos)
        << fault(root);
    EXPECT_NE(fault(folder.file("d0.pbrt")).find("deeper than 32"), std::string::npos);
    EXPECT_FAULT(world4("Include \"nowhere.pbrt\""), "2:9", "no file 'nowhere.pbrt'");
}

TEST(Reader, HashIsOfAllText) {
    const TempFolder folder;
    const std::string root = folder.write("s.pbrt", world4("Include \"i.pbrt\""));
    folder.write("i.pbrt", "Shape \"sphere\"");
    const std::string first = read_scene(root, models()).hash;
    EXPECT_EQ(first.size(), 64u);
    EXPECT_EQ(read_scene(root, models()).hash, first);
    folder.write("i.pbrt", "Shape \"sphere\" ");
    EXPECT_NE(read_scene(root, models()).hash, first);
}
