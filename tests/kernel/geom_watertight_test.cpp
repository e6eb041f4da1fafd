// SPDX-License-Identifier: Apache-2.0
// No ray slips between the triangles of a closed mesh, aimed exactly at edges and corners, from
// inside and outside. The same instrument finds the leaks of edge functions that are fused.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "base/kernel_text.h"
#include "support/meshes.h"
#include "support/trace_rig.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// A ray from `origin` through a point of float coordinates near `target`, as float allows.
TestRay aimed(const glm::dvec3& origin, const glm::dvec3& target) {
    const glm::vec3 o(origin);
    return {o, glm::vec3(glm::normalize(glm::dvec3(glm::vec3(target)) - glm::dvec3(o)))};
}

struct Aim {
    double tilt;  // of the mesh, degrees
    glm::dvec3 shift, stretch;
};

// All lie within [-1, 1]. Stretched meshes are full of slivers.
const std::vector<Aim> aims = {
    {0, {0, 0, 0}, {0.9, 0.9, 0.9}},
    {33, {0, 0, 0}, {0.9, 0.9, 0.9}},
    {71, {0.7, -0.6, 0.8}, {0.09, 0.09, 0.09}},
    {20, {0, 0, 0}, {0.9, 0.9, 0.0009}},
    {50, {-0.3, 0.2, 0.1}, {0.5, 0.00001, 0.3}},
};

class Closed {
  public:
    Closed(Mesh mesh, const Aim& aim) : mesh_(std::move(mesh)) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), aim.shift);
        m = glm::rotate(m, glm::radians(aim.tilt), glm::dvec3(0.3, 0.8, 0.5));
        to_world_ = glm::scale(m, aim.stretch);
        transform(mesh_, to_world_);
        // What the device sees are floats.
        for (glm::dvec3& p : mesh_.positions) p = glm::dvec3(glm::vec3(p));
    }

    const Mesh& mesh() const { return mesh_; }

    // A point of the inside: the mesh is star-shaped about its middle and not stretched to nothing.
    glm::dvec3 inside(Random& random) const {
        return glm::dvec3(to_world_ * glm::dvec4(0.3 * random_point(random), 1));
    }

    glm::dvec3 on_edge(Random& random) const {
        const glm::uvec3& t = triangle(random);
        const unsigned k = random.below(3);
        return glm::mix(mesh_.positions[t[k]], mesh_.positions[t[(k + 1) % 3]], random.uniform());
    }
    glm::dvec3 corner(Random& random) const { return mesh_.positions[triangle(random).x]; }

  private:
    const glm::uvec3& triangle(Random& random) const {
        return mesh_.triangles[random.below(unsigned(mesh_.triangles.size()))];
    }

    Mesh mesh_;
    glm::dmat4 to_world_;
};

// Rays from inside that meet nothing. All of them must meet something.
std::size_t leaks(const Program& program, const Closed& closed, bool corners, std::size_t count,
                  std::uint64_t seed) {
    const TraceRig rig(closed.mesh());
    Random random(seed);
    std::vector<TestRay> rays;
    for (std::size_t i = 0; i < count; ++i)
        rays.push_back(
            aimed(closed.inside(random), corners ? closed.corner(random) : closed.on_edge(random)));
    std::size_t leaked = 0;
    for (const TestHit& hit : rig.nearest(program, rays)) leaked += hit.primitive == LOBE_NONE;
    return leaked;
}

// Rays from outside that enter through an edge or a corner of the near side must meet something
// there, before they reach the inside point behind it that they are aimed at.
std::size_t outside_leaks(const Program& program, const Closed& closed, bool corners,
                          std::size_t count, std::uint64_t seed) {
    const TraceRig rig(closed.mesh());
    Random random(seed);
    std::vector<TestRay> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 in = closed.inside(random);
        const glm::dvec3 on = corners ? closed.corner(random) : closed.on_edge(random);
        TestRay ray = aimed(on + 0.5 * (on - in), on);
        ray.reach = float(glm::length(on - in) * 1.5);
        rays.push_back(ray);
    }
    std::size_t leaked = 0;
    for (const TestHit& hit : rig.nearest(program, rays)) leaked += hit.primitive == LOBE_NONE;
    return leaked;
}

// geom/triangle.h with one product of each edge function fused, as FP_CONTRACT ON does.
std::string fused_triangle_text() {
    std::string text = test_kernels().read("geom/triangle.h");
    const std::pair<const char*, const char*> changes[] = {
        {"cx * by - cy * bx", "fma(cx, by, -(cy * bx))"},
        {"ax * cy - ay * cx", "fma(ax, cy, -(ay * cx))"},
        {"bx * ay - by * ax", "fma(bx, ay, -(by * ax))"}};
    for (const auto& [from, to] : changes) {
        const auto at = text.find(from);
        if (at == std::string::npos) return "";
        text.replace(at, std::string(from).size(), to);
    }
    return text;
}

}  // namespace

TEST(GeomWatertight, NoRayLeaksAtSharedEdges) {
    const Program program = build_trace_probe();
    for (std::size_t i = 0; i < aims.size(); ++i) {
        const Closed closed(icosphere(4), aims[i]);
        EXPECT_EQ(leaks(program, closed, false, 140000, 10 + i), 0u) << "from inside, aim " << i;
        EXPECT_EQ(outside_leaks(program, closed, false, 60000, 20 + i), 0u) << "outside, aim " << i;
    }
}

TEST(GeomWatertight, NoRayLeaksAtSharedCorners) {
    const Program program = build_trace_probe();
    for (std::size_t i = 0; i < aims.size(); ++i) {
        const Closed closed(icosphere(4), aims[i]);
        EXPECT_EQ(leaks(program, closed, true, 140000, 30 + i), 0u) << "from inside, aim " << i;
        EXPECT_EQ(outside_leaks(program, closed, true, 60000, 40 + i), 0u) << "outside, aim " << i;
    }
}

// Large triangles whose edges lie in the planes of the axes and along rays parallel to them.
TEST(GeomWatertight, NoRayLeaksFromACube) {
    const Program program = build_trace_probe();
    const Closed closed(cube(), {0, {0, 0, 0}, {1, 1, 1}});
    EXPECT_EQ(leaks(program, closed, false, 200000, 50), 0u);
    EXPECT_EQ(leaks(program, closed, true, 100000, 51), 0u);
    const TraceRig rig(closed.mesh());
    std::vector<TestRay> rays;
    for (int x = -8; x <= 8; ++x)
        for (int y = -8; y <= 8; ++y)
            for (int axis = 0; axis < 3; ++axis)
                for (float side : {-1.0f, 1.0f}) {
                    glm::vec3 direction(0), origin(x / 8.5f, y / 8.5f, x / 9.0f);
                    direction[axis] = side;
                    if (x == y) origin = glm::vec3(0);
                    rays.push_back({origin, direction});
                }
    for (const TestHit& hit : rig.nearest(program, rays)) {
        EXPECT_NE(hit.primitive, LOBE_NONE);
        EXPECT_LE(hit.distance, 2);
    }
}

// These tests can fail: a fused edge function leaks about one ray in a hundred.
TEST(GeomWatertight, FusedEdgeFunctionsLeak) {
    const std::string fused = fused_triangle_text();
    ASSERT_NE(fused, "") << "geom/triangle.h has other edge functions than this test knows";
    const Program program = build_trace_probe("", {{"geom/triangle.h", fused}});
    EXPECT_GT(leaks(program, Closed(icosphere(4), aims[1]), false, 100000, 11), 100u);
}

// The pragma that forbids fusing is what keeps the compiler from it. Where the device's compiler
// would not fuse anyway (Oclgrind), there is nothing to see.
TEST(GeomWatertight, ContractionIsOffAndWouldLeak) {
    std::string real = test_kernels().read("core/real.h");
    const std::string off = "#pragma OPENCL FP_CONTRACT OFF";
    ASSERT_NE(real.find(off), std::string::npos);
    real.replace(real.find(off), off.size(), "#pragma OPENCL FP_CONTRACT ON");
    const Program program = build_trace_probe("", {{"core/real.h", real}});
    const std::size_t leaked = leaks(program, Closed(icosphere(4), aims[1]), false, 100000, 13);
    if (leaked == 0) GTEST_SKIP() << "this compiler fuses nothing";
    EXPECT_GT(leaked, 100u);
}
