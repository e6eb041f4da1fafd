// SPDX-License-Identifier: Apache-2.0
// Spheres against the quadratic in long double: tiny, huge, far, seen from inside, and met by rays
// that start on them.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "support/meshes.h"
#include "support/oracle.h"
#include "support/trace_rig.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr Long epsilon = 0x1p-24L;

struct Exact {
    Long near, far, tolerance;
    bool met, clear;  // clear: float cannot mistake a hit for a miss
};

// What float can know of it: the vector to the centre is rounded, and half the chord amplifies
// that near the silhouette.
Exact exact_hit(const LobeSphere& sphere, const TestRay& ray) {
    const vec3l f = vec3l(ray.origin) - vec3l(sphere.x, sphere.y, sphere.z);
    const vec3l d = glm::normalize(vec3l(ray.direction));
    const Long r = sphere.radius, b = -glm::dot(f, d);
    const Long across = glm::length(f + b * d), error = 8 * epsilon * glm::length(f);
    const Long half = std::sqrt(std::max(0.0L, (r - across) * (r + across)));
    Exact exact{b - half, b + half, 0, across <= r,
                std::fabs(across - r) > error + 4 * epsilon * r};
    exact.tolerance = (error + 4 * epsilon * r) * (1 + (half > 0 ? across / half : 0));
    return exact;
}

struct Counts {
    int hits = 0, misses = 0, wrong = 0;
};

// Rays towards and past a sphere of a radius at the origin of a box, from distances up to `far`.
Counts compare(const Program& program, double radius, double far, std::uint64_t seed) {
    Random random(seed);
    const glm::dvec3 centre = random_point(random) * std::max(0.0, 1 - radius);
    const TraceRig rig(Mesh(), {{centre, radius}});
    std::vector<TestRay> rays;
    for (int i = 0; i < 4096; ++i) {
        const glm::dvec3 aim = centre + 1.3 * radius * random_direction(random) * random.uniform();
        const glm::dvec3 origin = centre + far * random.uniform() * random_direction(random);
        const glm::dvec3 way = i % 8 ? aim - origin : random_direction(random);
        rays.push_back({glm::vec3(origin), glm::vec3(glm::normalize(way))});
    }
    const auto hits = rig.nearest(program, rays);
    Counts counts;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Exact exact = exact_hit(rig.packed().spheres[0], rays[i]);
        if (!exact.clear) continue;
        const bool met = hits[i].primitive == 0;
        std::optional<Long> distance;
        if (exact.met && exact.far > 0) distance = exact.near > 0 ? exact.near : exact.far;
        // An origin on the surface may be on either side of it.
        if (exact.met && std::min(std::fabs(exact.near), std::fabs(exact.far)) < exact.tolerance)
            continue;
        ++(met ? counts.hits : counts.misses);
        if (met != distance.has_value() ||
            (met && std::fabs(hits[i].distance - *distance) > exact.tolerance))
            ++counts.wrong;
    }
    return counts;
}

}  // namespace

TEST(GeomSphere, HitsAgreeWithTheQuadratic) {
    const Program program = build_trace_probe();
    std::uint64_t seed = 1;
    for (const double radius : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 0.999})
        for (const double far : {1.01 * radius, 0.9 * radius, 3 * radius, 1.0}) {
            const Counts counts = compare(program, radius, far, ++seed);
            EXPECT_EQ(counts.wrong, 0) << "radius " << radius << " seen from up to " << far;
            EXPECT_GT(counts.hits, 300) << "radius " << radius << " seen from up to " << far;
        }
}

// A ray that starts on a sphere meets its far side if it goes in, and nothing if it goes out.
TEST(GeomSphere, FromItsOwnSurface) {
    const Program program = build_trace_probe();
    Random random(5);
    for (const double radius : {1e-5, 1e-3, 0.1, 0.7}) {
        const glm::dvec3 centre = (1 - radius) * random_point(random);
        const TraceRig rig(Mesh(), {{centre, radius}});
        const LobeSphere& sphere = rig.packed().spheres[0];
        std::vector<TestRay> rays;
        std::vector<double> cosines;
        for (int i = 0; i < 20000; ++i) {
            const glm::dvec3 normal = random_direction(random), way = random_direction(random);
            const glm::dvec3 on = glm::dvec3(sphere.x, sphere.y, sphere.z) + radius * normal;
            TestRay ray{glm::vec3(on), glm::vec3(way)};
            ray.from = 0;
            rays.push_back(ray);
            cosines.push_back(glm::dot(normal, way));
        }
        const auto hits = rig.nearest(program, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            // The origin is off the surface by a rounding of coordinates of up to 1: inwards, rays
            // nearly along the surface may pass outside of it.
            const double off = 2e-7 / radius;
            if (cosines[i] > off) {
                EXPECT_EQ(hits[i].primitive, LOBE_NONE) << "cosine " << cosines[i];
            } else if (cosines[i] < -std::sqrt(2 * off)) {
                ASSERT_EQ(hits[i].primitive, 0u) << "cosine " << cosines[i];
                EXPECT_NEAR(hits[i].distance, -2 * radius * cosines[i],
                            1e-6 * radius + 4e-7 / std::min(1.0, -cosines[i]));
            }
        }
    }
}

// Many spheres in one block and one leaf: each lane its own.
TEST(GeomSphere, NeighboursInALeafAreTold) {
    const Program program = build_trace_probe();
    std::vector<Sphere> spheres;
    for (int i = 0; i < 13; ++i) spheres.push_back({{-0.9 + 0.15 * i, 0, 0}, 0.05});
    const TraceRig rig(Mesh(), spheres);
    std::vector<TestRay> rays;
    for (int i = 0; i < 13; ++i)
        rays.push_back({glm::vec3(-0.9 + 0.15 * i, 0.5, 0.01), glm::vec3(0, -1, 0)});
    rays.push_back({glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0)});
    rays.push_back({glm::vec3(1, 0.02, 0), glm::vec3(-1, 0, 0)});
    rays.push_back({glm::vec3(0, 0.06, 0), glm::vec3(1, 0, 0)});
    const auto hits = rig.nearest(program, rays);
    for (unsigned i = 0; i < 13; ++i) EXPECT_EQ(hits[i].primitive, i);
    EXPECT_EQ(hits[13].primitive, 0u);
    EXPECT_NEAR(hits[13].distance, 0.05, 1e-6);
    EXPECT_EQ(hits[14].primitive, 12u);
    EXPECT_EQ(hits[15].primitive, LOBE_NONE);
}
