// SPDX-License-Identifier: Apache-2.0
// Against Embree's robust mode on a mesh of 100,000 triangles: an intersector, a hierarchy and a
// way of rounding that share nothing with ours.
#include <gtest/gtest.h>

#include <cmath>

#include "support/embree_scene.h"
#include "support/meshes.h"
#include "support/trace_rig.h"

using namespace lobe;
using namespace lobe::test;

namespace {

TestHit nearest(const EmbreeScene& embree, const TestRay& ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit r = embree_ray(ray.origin, ray.direction, ray.reach);
    rtcIntersect1(embree.get(), &context, &r);
    const bool met = r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    return {r.ray.tfar, r.hit.u, r.hit.v, met ? r.hit.primID : LOBE_NONE};
}

// How near the ray passes to the edges of a triangle, as its smallest weight there in double.
double smallest_weight(const Mesh& mesh, std::uint32_t primitive, const TestRay& ray) {
    const glm::uvec3& t = mesh.triangles[primitive];
    const glm::dvec3 a(glm::vec3(mesh.positions[t.x])), o(ray.origin), d(ray.direction);
    const glm::dvec3 e1 = glm::dvec3(glm::vec3(mesh.positions[t.y])) - a;
    const glm::dvec3 e2 = glm::dvec3(glm::vec3(mesh.positions[t.z])) - a;
    const glm::dvec3 p = glm::cross(d, e2), s = o - a, q = glm::cross(s, e1);
    const double determinant = glm::dot(e1, p);
    const double b1 = glm::dot(s, p) / determinant, b2 = glm::dot(d, q) / determinant;
    return std::min({b1, b2, 1 - b1 - b2});
}

}  // namespace

TEST(GeomEmbree, SameHitsUpToEdges) {
    Mesh mesh = bumpy_torus(360, 140, 0.4, 0.2);
    transform(mesh, glm::dmat4(0.6));
    ASSERT_GT(mesh.triangles.size(), 100000u);
    const TraceRig rig(mesh);
    const EmbreeScene embree(mesh);
    Random random(3);
    std::vector<TestRay> rays;
    for (int i = 0; i < 300000; ++i) {
        const glm::dvec3 origin = random_point(random);
        const glm::dvec3 aim =
            i % 2 ? random_direction(random) : glm::normalize(0.8 * random_point(random) - origin);
        rays.push_back({glm::vec3(origin), glm::vec3(aim)});
    }
    const auto hits = rig.nearest(build_trace_probe(), rays);
    std::size_t met = 0, other = 0, unexplained = 0, far = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const TestHit theirs = nearest(embree, rays[i]), ours = hits[i];
        const bool hit = ours.primitive != LOBE_NONE;
        met += hit;
        if (ours.primitive == theirs.primitive) {
            far += hit && std::abs(ours.distance - theirs.distance) > 2e-5 * (1 + ours.distance);
            continue;
        }
        ++other;
        // Two may be right at an edge (the distances agree) or at a silhouette.
        if (hit && theirs.primitive != LOBE_NONE &&
            std::abs(ours.distance - theirs.distance) <= 2e-6)
            continue;
        double weight = 1;
        for (const std::uint32_t p : {ours.primitive, theirs.primitive})
            if (p != LOBE_NONE)
                weight = std::min(weight, std::abs(smallest_weight(mesh, p, rays[i])));
        unexplained += weight > 1e-4;
    }
    EXPECT_GT(met, 100000u);
    EXPECT_EQ(far, 0u);
    EXPECT_EQ(unexplained, 0u);
    EXPECT_LT(other, rays.size() / 1000);
    RecordProperty("other_primitive", int(other));
}
