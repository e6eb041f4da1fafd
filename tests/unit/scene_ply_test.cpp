// SPDX-License-Identifier: Apache-2.0
#include "scene/ply.h"

#include <algorithm>
#include <cstring>
#include <functional>

#include "scene_test_support.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const std::string ascii_file =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 5\nproperty float x\n"
    "property double y\nproperty float z\nproperty uchar red\nproperty float nx\n"
    "property float ny\nproperty float nz\nproperty float s\nproperty float t\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty uchar flag\n"
    "element edge 1\nproperty int a\nend_header\n"
    "0 0 0 9 0 0 1 0 0\n1 0 0 9 0 0 1 1 0\n1 1 0 9 0 0 1 1 1\n0 1 0 9 0 0 1 0 1\n"
    "-.5 .5 1e-1 9 0 0 1 .5 .5\n3 0 1 2 7\n4 0 2 3 4 7\n5\n";

// The same mesh as ascii_file.
std::string binary_file(bool big) {
    std::string out = ascii_file.substr(0, ascii_file.find("0 0 0 9"));
    out.replace(out.find("ascii"), 5, big ? "binary_big_endian" : "binary_little_endian");
    const auto put = [&](auto value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        if (big) std::reverse(bytes, bytes + sizeof value);
        out.append(bytes, sizeof value);
    };
    const double p[5][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-.5, .5, .1}};
    for (const auto& v : p) {
        put(static_cast<float>(v[0]));
        put(v[1]);
        put(static_cast<float>(v[2]));
        put(std::uint8_t(9));
        for (const float n : {0.f, 0.f, 1.f}) put(n);
        put(static_cast<float>(v[0] < 0 ? .5 : v[0]));
        put(static_cast<float>(v[1]));
    }
    const std::vector<std::vector<int>> faces{{0, 1, 2}, {0, 2, 3, 4}};
    for (const auto& face : faces) {
        put(static_cast<std::uint8_t>(face.size()));
        for (const int i : face) put(i);
        put(std::uint8_t(7));
    }
    put(5);
    return out;
}

std::string fault(const std::string& bytes) {
    try {
        parse_ply("m.ply", bytes);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::scene);
        return error.where() + " " + error.what();
    }
    return "";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

std::string windows(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '\n' ? "\r\n" : std::string(1, c);
    return out;
}

}  // namespace

TEST(Ply, ReadsEveryFormatAlike) {
    for (const std::string& file :
         {ascii_file, binary_file(false), binary_file(true), windows(ascii_file)}) {
        const Mesh mesh = parse_ply("m.ply", file);
        ASSERT_EQ(mesh.positions.size(), 5u);
        EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0));
        EXPECT_NEAR(mesh.positions[4].z, .1, 1e-7);
        EXPECT_EQ(mesh.positions[4].y, .5);
        EXPECT_EQ(mesh.normals.at(3), glm::vec3(0, 0, 1));
        EXPECT_EQ(mesh.uvs.at(4), glm::vec2(.5, .5));
        EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    }
}

TEST(Ply, TruncatedFilesAreErrorsAtEveryByte) {
    for (std::size_t size = 0; size + 1 < ascii_file.size(); ++size)  // the last newline may lack
        EXPECT_NE(fault(ascii_file.substr(0, size)), "") << size;
    for (const bool big : {false, true}) {
        const std::string file = binary_file(big);
        for (std::size_t size = 0; size < file.size(); ++size)
            EXPECT_NE(fault(file.substr(0, size)), "") << size;
    }
}

TEST(Ply, SaysWhereTheFaultIs) {
    EXPECT_EQ(fault(with(ascii_file, "1 1 0 9", "1 x 0 9")), "m.ply:22:3 'x' is not a number");
    EXPECT_EQ(fault(with(ascii_file, "1 1 0 9", "1 nan 0 9")),
              "m.ply:22:3 a vertex value is not finite");
    EXPECT_EQ(fault(with(ascii_file, "3 0 1 2", "3 0 1 5")),
              "m.ply:25:7 vertex index 5 is not one of the 5 vertices");
    EXPECT_EQ(fault(with(ascii_file, "3 0 1 2", "3 0 -1 2")),
              "m.ply:25:5 vertex index -1 is not one of the 5 vertices");
    EXPECT_EQ(fault(with(ascii_file, "3 0 1 2", "2 0 1 2")), "m.ply:25:1 a face of 2 corners");
    EXPECT_EQ(fault(with(ascii_file, "uchar flag", "uchr flag")),
              "m.ply:16:1 unknown property type 'uchr'");
    EXPECT_EQ(fault(with(ascii_file, "ascii 1.0", "ascii 2.0")),
              "m.ply:2:1 unknown format version '2.0'");
    EXPECT_NE(fault(with(ascii_file, "vertex_indices", "corners")).find("vertex_indices"),
              std::string::npos);
    EXPECT_NE(fault(with(ascii_file, "float x", "float w")).find("lacks x, y or z"),
              std::string::npos);
    EXPECT_NE(fault(with(ascii_file, "float x", "list uchar float x")).find("is a list"),
              std::string::npos);
    EXPECT_EQ(fault("plx\n"), "m.ply:1:1 not a PLY file: it does not begin with 'ply'");
    const std::string bad = with(binary_file(false), std::string("\x03\0\0\0\0", 5),
                                 std::string("\x03\xff\xff\xff\xff", 5));
    EXPECT_NE(fault(bad).find("m.ply vertex index -1 is not one of the 5 vertices (byte "),
              std::string::npos)
        << fault(bad);
}

TEST(Ply, NeverBelievesHugeCounts) {
    for (const std::string& file : {ascii_file, binary_file(false)}) {
        EXPECT_NE(fault(with(file, "vertex 5", "vertex 2147483648")).find("too short"),
                  std::string::npos);
        EXPECT_NE(fault(with(file, "face 2", "face 4294967295")).find("too short"),
                  std::string::npos);
        EXPECT_NE(fault(with(file, "vertex 5", "vertex 99999999999")).find("too many"),
                  std::string::npos);
        EXPECT_NE(fault(with(file, "vertex 5", "vertex -5")).find("wants a count"),
                  std::string::npos);
    }
    const std::string list =
        with(with(ascii_file, "list uchar", "list int"), "3 0 1 2", "2000000000 0 1 2");
    EXPECT_NE(fault(list).find("too short for a list"), std::string::npos) << fault(list);
    EXPECT_NE(fault("ply\nformat ascii 1.0\nelement vertex 4000000000\nend_header\n"), "");
}

TEST(Ply, ShapesReadTheirFiles) {
    const TempFolder folder;
    folder.write("m.ply", ascii_file);
    const std::string root = folder.write(
        "s.pbrt", world4("Scale 2 2 -2 Shape \"plymesh\" \"string filename\" \"m.ply\""));
    const Scene scene = read_scene(root, models());
    const Mesh& mesh = std::get<Mesh>(scene.shapes.at(0).geometry);
    EXPECT_EQ(mesh.positions[2], glm::dvec3(2, 2, 0));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, -1));
    EXPECT_TRUE(scene.shapes[0].flipped);  // winding +z, normals -z
    folder.write("m.ply", binary_file(true));
    EXPECT_NE(read_scene(root, models()).hash, scene.hash);
    EXPECT_FAULT(world4("Shape \"plymesh\" \"string filename\" \"none.ply\""), "2:35", "none.ply");
    EXPECT_FAULT(world4("Shape \"plymesh\""), "2:1", "lacks its parameter \"filename\"");
}
