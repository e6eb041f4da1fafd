// SPDX-License-Identifier: Apache-2.0
// Spheres and triangle meshes, and which way their normals point.
#include "scene_test_support.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const std::string triangle = "Shape \"trianglemesh\" \"point P\" [0 0 0 1 0 0 0 1 0] ";
const std::string up = "\"normal N\" [0 0 1 0 0 1 0 0 1] ";
const std::string down = "\"normal N\" [0 0 -1 0 0 -1 0 0 -1] ";

bool flipped(const std::string& lines, Dialect dialect = Dialect::v4) {
    ReadOptions options;
    options.dialect = dialect;
    return read_text("WorldBegin " + lines + (dialect == Dialect::v3 ? " WorldEnd" : ""), options)
        .shapes.at(0)
        .flipped;
}

// Where the geometric normal of the first triangle points.
glm::dvec3 normal(const std::string& lines) {
    const Scene scene = read_text(world4(lines));
    const Mesh& mesh = std::get<Mesh>(scene.shapes.at(0).geometry);
    const glm::uvec3 f = mesh.triangles[0];
    const auto& p = mesh.positions;
    const glm::dvec3 n = glm::normalize(glm::cross(p[f.y] - p[f.x], p[f.z] - p[f.x]));
    return scene.shapes[0].flipped ? -n : n;
}

}  // namespace

TEST(Shapes, SidesOfMeshesWithoutNormals) {
    EXPECT_FALSE(flipped(triangle));
    EXPECT_TRUE(flipped("ReverseOrientation " + triangle));
    EXPECT_TRUE(flipped("Scale -1 1 1 " + triangle));
    EXPECT_FALSE(flipped("ReverseOrientation Scale -1 1 1 " + triangle));
    // so that a mirrored triangle has the mirrored normal
    EXPECT_EQ(normal(triangle), glm::dvec3(0, 0, 1));
    EXPECT_EQ(normal("Scale -1 1 1 " + triangle), glm::dvec3(0, 0, 1));
    EXPECT_EQ(normal("Scale 1 1 -1 " + triangle), glm::dvec3(0, 0, -1));
}

TEST(Shapes, SidesOfMeshesWithNormals) {
    EXPECT_FALSE(flipped(triangle + up));
    EXPECT_TRUE(flipped(triangle + down));
    EXPECT_EQ(normal("Scale -1 1 1 " + triangle + up), glm::dvec3(0, 0, 1));
    EXPECT_FALSE(flipped("ReverseOrientation " + triangle + up, Dialect::v3));
    EXPECT_TRUE(flipped("ReverseOrientation " + triangle + up, Dialect::v4));
}

TEST(Shapes, TheMajorityDecidesTheSide) {
    const std::string three =
        "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0] "
        "\"integer indices\" [0 1 2 0 2 1 0 3 1] \"normal N\" [0 0 1 0 0 1 0 0 1 0 0 1]";
    const Scene scene = read_text(world4(three));
    EXPECT_TRUE(scene.shapes[0].flipped);
    const auto& triangles = std::get<Mesh>(scene.shapes[0].geometry).triangles;
    EXPECT_EQ(triangles[0], glm::uvec3(0, 2, 1));  // turned round to agree with the others
    EXPECT_EQ(triangles[1], glm::uvec3(0, 2, 1));
    EXPECT_EQ(triangles[2], glm::uvec3(0, 3, 1));
}

TEST(Shapes, SidesOfSpheres) {
    EXPECT_FALSE(flipped("Shape \"sphere\""));
    EXPECT_TRUE(flipped("ReverseOrientation Shape \"sphere\""));
    EXPECT_TRUE(flipped("Scale 1 -1 1 Shape \"sphere\""));
    EXPECT_FALSE(flipped("ReverseOrientation Scale 1 -1 1 Shape \"sphere\""));
}

TEST(Shapes, NormalsTransformAsNormals) {
    const Scene scene =
        read_text(world4("Scale 1 2 4 Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] "
                         "\"normal N\" [0 3 4 0 0 9 0 0 0] \"point2 uv\" [0 0 1 0 .5 1]"));
    const Mesh& mesh = std::get<Mesh>(scene.shapes[0].geometry);
    const glm::vec3 expected = glm::normalize(glm::vec3(0, 3.0 / 2, 4.0 / 4));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(mesh.normals[0][i], expected[i], 1e-6);
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));  // mended
    EXPECT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(mesh.uvs[2], glm::vec2(.5, 1));
    EXPECT_EQ(mesh.positions[2], glm::dvec3(0, 2, 0));
}

TEST(Shapes, CoordinatesKeepTheirDoubles) {
    const Scene scene =
        read_text(world4("Translate 1e9 0 0 Shape \"trianglemesh\" "
                         "\"point3 P\" [0.0001 0 0 1 0 0 0 1 0]"));
    EXPECT_NEAR(std::get<Mesh>(scene.shapes[0].geometry).positions[0].x - 1e9, 1e-4, 1e-6);
}

TEST(Shapes, FlatTrianglesAreKeptAndCounted) {
    const Scene scene =
        read_text(world4("Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 2 0 0 0 1 0]"
                         "\"integer indices\" [0 1 2 0 1 1 0 1 3]"));
    EXPECT_EQ(std::get<Mesh>(scene.shapes[0].geometry).triangles.size(), 3u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("2 of 3 triangles have no area"), std::string::npos);
}

TEST(Shapes, FaultsOfSpheres) {
    EXPECT_FAULT(world4("Shape \"sphere\" \"float radius\" 0"), "2:16", "radius");
    EXPECT_FAULT(world4("Shape \"sphere\" \"float zmin\" -.5"), "2:16", "not supported yet");
    EXPECT_FAULT(world4("Shape \"sphere\" \"float phimax\" 180"), "2:16", "not supported yet");
    EXPECT_EQ(fault_of(world4("Shape \"sphere\" \"float phimax\" 360 \"float zmax\" 1")), "");
    EXPECT_FAULT(world4("Scale 1 1 2 Shape \"sphere\""), "2:13", "stretches");
    EXPECT_FAULT(world4("Shape \"sphere\" \"float radios\" 2"), "2:16", "did you mean 'radius'");
    EXPECT_FAULT(world4("Shape \"spere\""), "2:7", "did you mean 'sphere'");
    EXPECT_FAULT(world4("Shape \"cylinder\""), "2:7", "understood but not supported yet");
    EXPECT_FAULT(world3("Shape \"sphere\" \"rgb Kd\" [1 1 1]"), "2:16", "not supported yet");
    EXPECT_FAULT(world4("Shape \"sphere\" \"string radius\" \"2\""), "2:16",
                 "wants float, has string");
    EXPECT_FAULT(world4("Shape \"sphere\" \"float radius\" [2 3]"), "2:16",
                 "wants 1 number, has 2");
}

TEST(Shapes, FaultsOfTriangleMeshes) {
    const std::string mesh = "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]\n";
    EXPECT_FAULT(world4(mesh + "\"integer indices\" [0 1\n 3]"), "4:2",
                 "vertex index 3 is not one of the 3 vertices");
    EXPECT_FAULT(world4(mesh + "\"integer indices\" [0 -1 2]"), "3:22", "vertex index -1");
    EXPECT_FAULT(world4(mesh + "\"integer indices\" [0 1 2 0]"), "3:1", "three indices");
    EXPECT_FAULT(world4(mesh + "\"normal N\" [0 0 1]"), "3:1", "wants 9 numbers for 3 vertices");
    EXPECT_FAULT(world4(mesh + "\"point2 uv\" [0 0 1 1]"), "3:1", "wants 6 numbers");
    EXPECT_FAULT(world4(mesh + "\"float alpha\" .5"), "3:1", "not supported yet");
    EXPECT_FAULT(world4("Shape \"trianglemesh\" \"integer indices\" [0 1 2]"), "2:1", "lacks");
    EXPECT_FAULT(world4("Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 1]"), "2:1",
                 "lacks its parameter \"indices\"");
    EXPECT_FAULT(world4("Scale 1e300 1e300 1e300 Shape \"trianglemesh\" \"point3 P\" [1e300 0 0 "
                        "1 0 0 0 1 0]"),
                 "2:25", "not finite");
}
