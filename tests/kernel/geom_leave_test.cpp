// SPDX-License-Identifier: Apache-2.0
// A ray that leaves a surface does not meet it again, whatever the scale of the scene and wherever
// it lies, and yet it starts so near that nothing is missed.
#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/trace_rig.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr int ray_count = 50000;

Scene placed(Mesh mesh, double scale, double offset) {
    for (glm::dvec3& p : mesh.positions) p = scale * (p + offset * glm::dvec3(1, -0.7, 0.4));
    return scene_of({shape_of(std::move(mesh))});
}

glm::dvec3 position(const PackedScene& packed, std::uint32_t vertex) {
    const LobeVertex& v = packed.vertices[vertex];
    return {v.px, v.py, v.pz};
}

glm::dvec3 normal_of(const PackedScene& packed, std::uint32_t primitive) {
    const LobeTriangle& t = packed.triangles[primitive];
    const glm::dvec3 a = position(packed, t.v0);
    return glm::normalize(glm::cross(position(packed, t.v1) - a, position(packed, t.v2) - a));
}

struct Leaving {
    std::vector<LeavingRay> rays;
    int again = 0;  // met the convex shape from outside, by name or without
    int again_unnamed = 0;
    float largest_shift = 0;
};

// Rays that hit a convex mesh from outside leave it on that side, half of them nearly along it.
Leaving leave_convex(const Program& program, const TraceRig& rig, double extent) {
    Random random(9);
    std::vector<TestRay> rays;
    for (int i = 0; i < ray_count; ++i) {
        const glm::dvec3 on = extent * random_direction(random);
        const glm::dvec3 from = 2.0 * extent * random_direction(random);
        rays.push_back({glm::vec3(from), glm::vec3(glm::normalize(0.7 * on - from))});
    }
    const auto hits = rig.nearest(program, rays);
    std::vector<glm::vec3> ways;
    for (int i = 0; i < ray_count; ++i) {
        if (hits[i].primitive == LOBE_NONE) {
            ways.emplace_back(0, 0, 1);
            continue;
        }
        const glm::dvec3 n = normal_of(rig.packed(), hits[i].primitive);
        const double side = glm::dot(n, glm::dvec3(rays[i].direction)) < 0 ? 1 : -1;
        const glm::dvec3 tangent = glm::normalize(glm::cross(n, random_direction(random)));
        const double cosine = i % 2 ? random.uniform() : random.log_uniform(1e-6, 1);
        ways.emplace_back(
            glm::normalize(side * cosine * n + std::sqrt(1 - cosine * cosine) * tangent));
    }
    Leaving result;
    result.rays = rig.leave(program, rays, ways);
    std::vector<TestRay> next;
    for (const LeavingRay& ray : result.rays)
        if (ray.ray.from != LOBE_NONE) {
            next.push_back(ray.ray);
            result.largest_shift = std::max(result.largest_shift, ray.shift);
        }
    for (const TestHit& hit : rig.nearest(program, next))
        result.again += hit.primitive != LOBE_NONE;
    for (TestRay& ray : next) ray.from = LOBE_NONE;
    for (const TestHit& hit : rig.nearest(program, next))
        result.again_unnamed += hit.primitive != LOBE_NONE;
    return result;
}

}  // namespace

TEST(GeomLeave, NoSelfHitsAtAnyScale) {
    const Program program = build_trace_probe();
    for (const double offset : {0.0, 100.0})
        for (const double scale : {1e-6, 1e-2, 1.0, 1e2, 1e6}) {
            const TraceRig rig(placed(icosphere(2), scale, offset));
            const double extent = scale * rig.packed().placement.scale;
            const Leaving result = leave_convex(program, rig, extent);
            EXPECT_EQ(result.again, 0) << "scale " << scale << ", offset " << offset;
            // Even without names: at most five in a hundred thousand.
            EXPECT_LE(result.again_unnamed, ray_count / 20000)
                << "scale " << scale << ", offset " << offset;
            EXPECT_LE(result.largest_shift, 4e-6 * extent) << "scale " << scale;
            EXPECT_GT(result.largest_shift, 0);
        }
}

// The same for a sphere, whose own name lets a ray see its far side only.
TEST(GeomLeave, SpheresDoNotMeetThemselves) {
    const Program program = build_trace_probe();
    Random random(4);
    for (const double radius : {1e-4, 1e-2, 0.3}) {
        const TraceRig rig(Mesh(), {{(1 - radius) * random_point(random), radius}});
        const LobeSphere& s = rig.packed().spheres[0];
        const glm::dvec3 centre(s.x, s.y, s.z);
        std::vector<TestRay> rays;
        std::vector<glm::vec3> ways;
        std::vector<bool> outwards;
        for (int i = 0; i < ray_count; ++i) {
            const glm::dvec3 n = random_direction(random);
            const glm::dvec3 from = centre + radius * (n + 0.5 * random_point(random) + 2.0 * n);
            rays.push_back(
                {glm::vec3(from), glm::vec3(glm::normalize(centre + radius * n - from))});
            // The device's normal is not known here: keep off the tangent by its rounding.
            const glm::dvec3 tangent = glm::normalize(glm::cross(n, random_direction(random)));
            const double cosine = random.uniform(0.05, 1) * (i % 2 ? 1 : -1);
            ways.emplace_back(
                glm::normalize(cosine * n + std::sqrt(1 - cosine * cosine) * tangent));
        }
        const auto leaving = rig.leave(program, rays, ways);
        std::vector<TestRay> next;
        for (const LeavingRay& ray : leaving) next.push_back(ray.ray);
        const auto hits = rig.nearest(program, next);
        int wrong = 0, met = 0;
        for (int i = 0; i < ray_count; ++i) {
            if (next[i].from == LOBE_NONE) continue;
            const glm::dvec3 n = (glm::dvec3(next[i].origin) - centre) / double(s.radius);
            const double cosine = glm::dot(n, glm::dvec3(next[i].direction));
            if (std::abs(cosine) < 0.02) continue;
            ++met;
            wrong += (hits[i].primitive == 0) != (cosine < 0);
            EXPECT_LE(leaving[i].shift, 3e-6);
        }
        EXPECT_EQ(wrong, 0) << "radius " << radius;
        EXPECT_GT(met, ray_count / 2);
    }
}

// Inside a closed mesh a ray that leaves any hit inwards meets the mesh again: none gets out.
TEST(GeomLeave, NoRayGetsOutOfAClosedMesh) {
    const Program program = build_trace_probe();
    for (const double scale : {1e-6, 1.0, 1e6})
        for (const double offset : {0.0, 100.0}) {
            Mesh torus = bumpy_torus(40, 20, 0.5, 0.2);
            const TraceRig rig(placed(torus, scale, offset));
            const double extent = scale * rig.packed().placement.scale;
            const glm::dvec3 middle = rig.packed().placement.point(
                scale * (glm::dvec3(0) + offset * glm::dvec3(1, -0.7, 0.4)));
            Random random(2);
            std::vector<TestRay> rays;
            for (int i = 0; i < ray_count; ++i) {  // from the circle within the tube
                const double angle = random.uniform(0, 6.28318);
                const glm::dvec3 circle(std::cos(angle), std::sin(angle), 0);
                rays.push_back(
                    {glm::vec3(middle + extent * circle), glm::vec3(random_direction(random))});
            }
            for (int bounce = 0; bounce < 8; ++bounce) {
                const auto hits = rig.nearest(program, rays);
                std::vector<glm::vec3> ways;
                int lost = 0;
                for (int i = 0; i < ray_count; ++i) {
                    if (hits[i].primitive == LOBE_NONE) {
                        ++lost;
                        ways.emplace_back(0, 0, 1);
                        continue;
                    }
                    const glm::dvec3 n = -normal_of(rig.packed(), hits[i].primitive);
                    const glm::dvec3 tangent =
                        glm::normalize(glm::cross(n, random_direction(random)));
                    const double cosine = random.log_uniform(1e-4, 1);
                    ways.emplace_back(
                        glm::normalize(cosine * n + std::sqrt(1 - cosine * cosine) * tangent));
                }
                ASSERT_EQ(lost, 0)
                    << "scale " << scale << ", offset " << offset << ", bounce " << bounce;
                std::vector<TestRay> next;
                for (const LeavingRay& ray : rig.leave(program, rays, ways))
                    next.push_back(ray.ray);
                rays = next;
            }
        }
}
