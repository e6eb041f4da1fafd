// SPDX-License-Identifier: Apache-2.0
#include "scene/loop_subdivision.h"

#include <cmath>
#include <map>
#include <set>

#include "scene_test_support.h"

using namespace lobe;
using namespace lobe::test;

namespace {

SubdivisionMesh tetrahedron() {
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
            {},
            {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

SubdivisionMesh icosahedron() {
    const double t = (1 + std::sqrt(5.0)) / 2;
    SubdivisionMesh mesh{
        {{-1, t, 0},
         {1, t, 0},
         {-1, -t, 0},
         {1, -t, 0},
         {0, -1, t},
         {0, 1, t},
         {0, -1, -t},
         {0, 1, -t},
         {t, 0, -1},
         {t, 0, 1},
         {-t, 0, -1},
         {-t, 0, 1}},
        {},
        {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    return mesh;
}

// A sheet of size x size vertices in a plane, cut into equilateral triangles.
SubdivisionMesh sheet(unsigned size, double (*height)(double, double)) {
    SubdivisionMesh mesh;
    for (unsigned j = 0; j < size; ++j)
        for (unsigned i = 0; i < size; ++i) {
            const double x = i + 0.5 * j, y = j * std::sqrt(3.0) / 2;
            mesh.positions.emplace_back(x, y, height(x, y));
        }
    for (unsigned j = 0; j + 1 < size; ++j)
        for (unsigned i = 0; i + 1 < size; ++i) {
            const unsigned v = j * size + i;
            mesh.triangles.emplace_back(v, v + 1, v + size);
            mesh.triangles.emplace_back(v + 1, v + size + 1, v + size);
        }
    return mesh;
}

std::string fault(std::vector<glm::uvec3> triangles, std::size_t vertices) {
    SubdivisionMesh mesh;
    for (std::size_t i = 0; i < vertices; ++i) mesh.positions.emplace_back(i, i * i, i * i * i);
    mesh.triangles = std::move(triangles);
    return loop_subdivide(mesh, 1);
}

}  // namespace

TEST(Loop, CountsOfAClosedMesh) {
    for (int levels = 0; levels < 5; ++levels) {
        SubdivisionMesh mesh = tetrahedron();
        ASSERT_EQ(loop_subdivide(mesh, levels), "");
        const std::size_t faces = std::size_t(4) << (2 * levels);
        EXPECT_EQ(mesh.triangles.size(), faces);
        EXPECT_EQ(mesh.positions.size(), faces / 2 + 2);  // Euler
        EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    }
}

TEST(Loop, LimitOfATetrahedronsCorner) {
    // valence 3: beta = 3/16, gamma = 1 / (3 + 3 / (8 beta)) = 1/5; the ring's sum is -corner
    for (int levels = 0; levels < 4; ++levels) {
        SubdivisionMesh mesh = tetrahedron();
        loop_subdivide(mesh, levels);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(mesh.positions[0][i], 2.0 / 5 - 1.0 / 5, 1e-12);
    }
}

TEST(Loop, LimitOfAVertexDoesNotDependOnTheLevel) {
    SubdivisionMesh coarse = sheet(7, [](double x, double y) { return std::sin(3 * x + y); });
    SubdivisionMesh fine = coarse;
    const std::size_t vertices = coarse.positions.size();
    loop_subdivide(coarse, 0);
    loop_subdivide(fine, 3);
    for (std::size_t v = 0; v < vertices; ++v) {
        EXPECT_NEAR(glm::dot(coarse.normals[v], fine.normals[v]), 1, 1e-9) << v;
        // on the boundary pbrt's mask is not quite that of the limit
        const bool boundary = v < 7 || v >= 42 || v % 7 == 0 || v % 7 == 6;
        const double error = boundary ? 0 : glm::distance(coarse.positions[v], fine.positions[v]);
        EXPECT_NEAR(error, 0, 1e-12) << v;
    }
}

TEST(Loop, ARegularVertexMovesToItsRingByTwelfths) {
    SubdivisionMesh mesh = sheet(5, [](double, double) { return 0.0; });
    mesh.positions[12].z = 1;  // the middle
    loop_subdivide(mesh, 0);
    EXPECT_NEAR(mesh.positions[12].z, 0.5, 1e-12);       // 1 - 6/12
    EXPECT_NEAR(mesh.positions[13].z, 1.0 / 12, 1e-12);  // a neighbour
}

TEST(Loop, PlanesStayPlanesWithTheirNormal) {
    SubdivisionMesh mesh = sheet(5, [](double x, double y) { return 2 * x - y; });
    ASSERT_EQ(loop_subdivide(mesh, 2), "");
    const glm::dvec3 against_winding = -glm::normalize(glm::dvec3(-2, 1, 1));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::dvec3 p = mesh.positions[v];
        EXPECT_NEAR(p.z, 2 * p.x - p.y, 1e-12);
        EXPECT_NEAR(glm::dot(mesh.normals[v], against_winding), 1, 1e-12) << v;
    }
}

TEST(Loop, TheBoundaryIsACurveOfItsOwn) {
    // one triangle: its corners go to (3 a + b + c) / 5, and the middle does not matter
    SubdivisionMesh mesh{{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}}, {}, {{0, 1, 2}}};
    SubdivisionMesh fine = mesh;
    ASSERT_EQ(loop_subdivide(mesh, 0), "");
    EXPECT_NEAR(glm::distance(mesh.positions[0], glm::dvec3(1, 1, 0)), 0, 1e-12);
    EXPECT_NEAR(glm::distance(mesh.positions[1], glm::dvec3(3, 1, 0)), 0, 1e-12);
    ASSERT_EQ(loop_subdivide(fine, 1), "");
    // after one level: corner (6 a + b + c) / 8, edges halved; then the limit
    EXPECT_NEAR(glm::distance(fine.positions[0], glm::dvec3(.875, .875, 0)), 0, 1e-12);
    const glm::dvec3 middle(2.5, 0, 0), corner0(.625, .625, 0), corner1(3.75, .625, 0);
    const glm::dvec3 limit = (3.0 * middle + corner0 + corner1) / 5.0;
    bool found = false;
    for (const glm::dvec3& p : fine.positions) found |= glm::distance(p, limit) < 1e-12;
    EXPECT_TRUE(found);
}

TEST(Loop, AnIcosahedronBecomesNearlyASphere) {
    SubdivisionMesh mesh = icosahedron();
    ASSERT_EQ(loop_subdivide(mesh, 3), "");
    double least = 1e9, most = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const double radius = glm::length(mesh.positions[v]);
        least = std::min(least, radius);
        most = std::max(most, radius);
        // pbrt's side: against the winding, which is outwards here
        EXPECT_GT(glm::dot(mesh.normals[v], -mesh.positions[v] / radius), 0.995);
        EXPECT_NEAR(glm::length(mesh.normals[v]), 1, 1e-12);
    }
    EXPECT_LT(most / least, 1.04);
}

TEST(Loop, NormalsAreThoseOfTheLimitSurface) {
    // against the finite differences of a much finer mesh around the same vertex
    SubdivisionMesh mesh = sheet(6, [](double x, double y) { return 0.3 * x * y; });
    SubdivisionMesh fine = mesh;
    const std::size_t vertices = mesh.positions.size();
    loop_subdivide(mesh, 0);
    loop_subdivide(fine, 5);
    std::vector<glm::dvec3> sums(fine.positions.size(), glm::dvec3(0));
    for (const glm::uvec3& f : fine.triangles) {
        const auto& p = fine.positions;
        const glm::dvec3 n = glm::cross(p[f.y] - p[f.x], p[f.z] - p[f.x]);
        for (int k = 0; k < 3; ++k) sums[f[k]] -= n;
    }
    for (std::size_t v = 0; v < vertices; ++v)
        EXPECT_GT(glm::dot(mesh.normals[v], glm::normalize(sums[v])), 0.9995) << v;
}

// With seven neighbours and more the scheme itself has no tangent plane at the boundary.
TEST(Loop, BoundaryNormalsAreThoseOfTheLimit) {
    for (unsigned spokes = 2; spokes < 7; ++spokes) {
        SubdivisionMesh mesh{{{0, 0, 0}}, {}, {}};
        for (unsigned i = 0; i < spokes; ++i) {
            const double angle = 3.0 * i / (spokes - 1);
            mesh.positions.emplace_back(std::cos(angle), std::sin(angle), std::sin(7 * angle + 1));
            if (i > 0) mesh.triangles.emplace_back(0, i, i + 1);
        }
        SubdivisionMesh fine = mesh;
        ASSERT_EQ(loop_subdivide(mesh, 0), "");
        ASSERT_EQ(loop_subdivide(fine, 3), "");
        EXPECT_NEAR(glm::dot(mesh.normals[0], fine.normals[0]), 1, 1e-9) << spokes;
    }
}

TEST(Loop, RefusesWhatIsNoManifold) {
    EXPECT_EQ(fault({{0, 1, 2}, {1, 0, 3}}, 4), "");
    EXPECT_EQ(fault({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5),
              "more than two triangles share the edge of vertices 0 and 1");
    EXPECT_EQ(fault({{0, 1, 2}, {0, 1, 3}}, 4),
              "two triangles wind differently at the edge of vertices 0 and 1");
    EXPECT_EQ(fault({{0, 1, 2}, {0, 3, 4}}, 5), "the surface touches itself in vertex 0");
    EXPECT_EQ(fault({{0, 0, 2}}, 3), "triangle 0 has vertex 0 twice");
    // two closed surfaces with one corner in common
    EXPECT_EQ(fault({{0, 1, 2},
                     {0, 2, 3},
                     {0, 3, 1},
                     {1, 3, 2},
                     {0, 4, 5},
                     {0, 5, 6},
                     {0, 6, 4},
                     {4, 6, 5}},
                    7),
              "the surface touches itself in vertex 0");
}

TEST(Loop, DropsVerticesThatNothingUses) {
    SubdivisionMesh mesh{{{9, 9, 9}, {0, 0, 0}, {5, 0, 0}, {8, 8, 8}, {0, 5, 0}}, {}, {{1, 2, 4}}};
    ASSERT_EQ(loop_subdivide(mesh, 0), "");
    EXPECT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2));
}

TEST(Loop, ShapesReadTheirLevels) {
    const std::string mesh =
        "Shape \"loopsubdiv\" \"integer indices\" [0 1 2 0 2 3 0 3 1 1 3 2] "
        "\"point P\" [1 1 1 1 -1 -1 -1 1 -1 -1 -1 1] ";
    const auto faces = [&](const std::string& more) {
        const Scene scene = read_text(world3(mesh + more));
        return std::get<Mesh>(scene.shapes.at(0).geometry).triangles.size();
    };
    EXPECT_EQ(faces(""), 256u);  // three
    EXPECT_EQ(faces("\"integer nlevels\" 1"), 16u);
    EXPECT_EQ(faces("\"integer nlevels\" 1 \"integer levels\" 2"), 64u);
    EXPECT_TRUE(read_text(world3(mesh)).shapes[0].flipped);
    EXPECT_FAULT(world3(mesh + "\n\"integer levels\" 12"), "3:1", "too many");
    EXPECT_FAULT(world3(mesh + "\n\"integer levels\" -1"), "3:1", "has -1");
    EXPECT_FAULT(world3("Shape \"loopsubdiv\"\n\"integer indices\" [0 1 2 0 1 2] "
                        "\"point P\" [1 1 1 1 -1 -1 -1 1 -1]"),
                 "3:1", "wind differently");
}
