// SPDX-License-Identifier: Apache-2.0
// The hierarchy loses nothing and adds nothing: what it finds is what a visit to every primitive
// finds, to the bit, on meshes and rays made to be unpleasant.
#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/trace_rig.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr int rays_per_mesh = 4096;

// Rays of all kinds at a mesh: anywhere, along the axes, in the planes of triangles, at corners.
std::vector<TestRay> unpleasant_rays(Random& random, const Mesh& mesh, double scale,
                                     const glm::dvec3& offset) {
    std::vector<TestRay> rays;
    for (int i = 0; i < rays_per_mesh; ++i) {
        const glm::uvec3& t = mesh.triangles[random.below(unsigned(mesh.triangles.size()))];
        const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        glm::dvec3 origin = offset + scale * random_point(random);
        glm::dvec3 target = offset + scale * random_point(random);
        switch (random.below(6)) {
            case 0:
                target = origin;
                target[random.below(3)] += scale;
                break;
            case 1:
                target = a;
                break;
            case 2:
                target = glm::mix(a, b, random.uniform());
                break;
            case 3:  // in the plane of a triangle, across it
                origin = a + 3.0 * (b - a) * random.uniform(-1, 1) + 2.0 * (c - a);
                target = glm::mix(a, b, random.uniform());
                break;
            case 4:
                origin = a, target = b;
                break;  // along an edge
            default:
                break;
        }
        glm::dvec3 direction = target - origin;
        if (glm::length(direction) == 0) direction = glm::dvec3(0, 0, -1);
        TestRay ray{glm::vec3(origin), glm::vec3(glm::normalize(direction))};
        if (random.below(4) == 0) ray.from = random.below(unsigned(mesh.triangles.size()));
        if (random.below(4) == 0) ray.reach = float(scale * random.uniform(0, 2));
        rays.push_back(ray);
    }
    return rays;
}

struct Case {
    Mesh mesh;
    std::vector<Sphere> spheres;
    std::vector<TestRay> rays;
};

// Mesh number i: sizes from one triangle to thousands, scales from 1e-6 to 1, some off the origin.
Case unpleasant_case(unsigned i) {
    Random random(100 + i);
    Case c;
    c.mesh = triangle_soup(random, 1 + (1u << (i % 12)));
    const double scale = random.log_uniform(1e-6, 1);
    glm::dvec3 offset(0);
    if (i % 3 == 1) offset = (1 - scale) * random_point(random);
    for (glm::dvec3& p : c.mesh.positions) p = offset + scale * p;
    if (i % 4 == 2)
        for (int k = 0; k < 50; ++k)
            c.spheres.push_back(
                {offset + scale * random_point(random), scale * random.log_uniform(1e-5, 0.5)});
    c.rays = unpleasant_rays(random, c.mesh, scale, offset);
    return c;
}

// Whether a ray sees a triangle so nearly edge-on (or the triangle has so little area) that the
// place where they meet is not defined in float: then a hit may be computed to lie outside the
// triangle's box, and only a visit to every primitive finds it.
bool edge_on(const Mesh& mesh, const TestRay& ray, const TestHit& hit) {
    if (hit.primitive >= mesh.triangles.size()) return false;
    const glm::uvec3& t = mesh.triangles[hit.primitive];
    const glm::dvec3 e1 = mesh.positions[t.y] - mesh.positions[t.x];
    const glm::dvec3 e2 = mesh.positions[t.z] - mesh.positions[t.x];
    const double volume = std::abs(glm::dot(glm::dvec3(ray.direction), glm::cross(e1, e2)));
    return volume <= 1e-5 * glm::length(e1) * glm::length(e2);
}

std::string text(const TestHit& hit) {
    return "primitive " + std::to_string(hit.primitive) + " at " + std::to_string(hit.distance);
}

}  // namespace

TEST(GeomBruteForce, HierarchyFindsTheSameBits) {
    const Program program = build_trace_probe();
    std::size_t hits = 0, undefined = 0;
    for (unsigned i = 0; i < 64; ++i) {
        const Case c = unpleasant_case(i);
        const TraceRig rig(c.mesh, c.spheres);
        const auto found = rig.nearest(program, c.rays), exact = rig.linear(program, c.rays);
        std::size_t wrong = 0, first = 0;
        for (std::size_t k = 0; k < c.rays.size(); ++k) {
            hits += exact[k].primitive != LOBE_NONE;
            if (found[k].same(exact[k], c.mesh.triangles.size())) continue;
            if (edge_on(c.mesh, c.rays[k], exact[k])) {
                ++undefined;
            } else if (wrong++ == 0) {
                first = k;
            }
        }
        EXPECT_EQ(wrong, 0u) << "mesh " << i << ", ray " << first << ": " << text(found[first])
                             << ", should be " << text(exact[first]);
    }
    EXPECT_GT(hits, 64u * rays_per_mesh / 4);
    EXPECT_LE(undefined, 10u);  // of 262,144 rays; 2 when this was written
}

// A triangle given twice is met as the first of the two, wherever the hierarchy puts them.
TEST(GeomBruteForce, LowerOfTwoPrimitivesWins) {
    Random random(7);
    Mesh mesh = bumpy_torus(24, 12);
    const auto count = unsigned(mesh.triangles.size());
    for (unsigned i = 0; i < count; ++i) mesh.triangles.push_back(mesh.triangles[i]);
    const TraceRig rig(mesh, {{{0, 0, 0}, 0.3}, {{0, 0, 0}, 0.3}});
    std::vector<TestRay> rays;
    for (int i = 0; i < 20000; ++i)
        rays.push_back(
            {glm::vec3(2.0 * random_point(random)), glm::vec3(random_direction(random))});
    const Program program = build_trace_probe();
    const auto hits = rig.nearest(program, rays);
    std::size_t spheres = 0, triangles = 0;
    for (const TestHit& hit : hits) {
        if (hit.primitive == LOBE_NONE) continue;
        const bool sphere = hit.primitive >= 2 * count;
        ++(sphere ? spheres : triangles);
        EXPECT_TRUE(sphere ? hit.primitive == 2 * count : hit.primitive < count) << text(hit);
    }
    EXPECT_GT(spheres, 100u);
    EXPECT_GT(triangles, 1000u);
}

// Devices without AVX take other lane masks: these must not change a bit.
TEST(GeomBruteForce, PortableLanesGiveTheSameBits) {
    const Program own = build_trace_probe();
    const Program portable = build_trace_probe("#define LOBE_PORTABLE_LANES\n");
    for (unsigned i = 0; i < 16; ++i) {
        const Case c = unpleasant_case(i);
        const TraceRig rig(c.mesh, c.spheres);
        EXPECT_TRUE(rig.nearest(own, c.rays) == rig.nearest(portable, c.rays)) << "mesh " << i;
        EXPECT_TRUE(rig.occluded(own, c.rays) == rig.occluded(portable, c.rays)) << "mesh " << i;
    }
}

// An any-hit ray is stopped exactly where a nearest-hit ray of the same reach meets something.
TEST(GeomBruteForce, OcclusionAgreesWithNearestHit) {
    const Program program = build_trace_probe();
    std::size_t met = 0;
    for (unsigned i = 0; i < 32; ++i) {
        const Case c = unpleasant_case(i);
        const TraceRig rig(c.mesh, c.spheres);
        const auto hits = rig.nearest(program, c.rays);
        const auto occluded = rig.occluded(program, c.rays);
        std::size_t wrong = 0;
        for (std::size_t k = 0; k < c.rays.size(); ++k) {
            wrong += (hits[k].primitive != LOBE_NONE) != (occluded[k] != 0);
            met += occluded[k] != 0;
        }
        EXPECT_EQ(wrong, 0u) << "mesh " << i;
    }
    EXPECT_GT(met, 10000u);
}

// The target does not stop a shadow ray, whatever else does.
TEST(GeomBruteForce, OcclusionIgnoresItsTarget) {
    const Program program = build_trace_probe();
    std::size_t alone = 0, behind = 0;
    for (unsigned i = 0; i < 16; ++i) {
        Case c = unpleasant_case(i);
        const TraceRig rig(c.mesh, c.spheres);
        const auto first = rig.nearest(program, c.rays);
        std::vector<TestRay> second = c.rays;
        for (std::size_t k = 0; k < c.rays.size(); ++k) c.rays[k].target = first[k].primitive;
        const auto occluded = rig.occluded(program, c.rays);
        // Without its target the ray meets what it meets when it starts `from` it.
        for (std::size_t k = 0; k < second.size(); ++k) second[k].from = first[k].primitive;
        const auto others = rig.nearest(program, second);
        for (std::size_t k = 0; k < c.rays.size(); ++k) {
            const bool plain = first[k].primitive < c.mesh.triangles.size();
            if (!plain || c.rays[k].from != LOBE_NONE) continue;
            const bool expected = others[k].primitive != LOBE_NONE;
            ASSERT_EQ(occluded[k] != 0, expected) << "mesh " << i << ", ray " << k;
            ++(expected ? behind : alone);
        }
    }
    EXPECT_GT(alone, 1000u);
    EXPECT_GT(behind, 1000u);
}
