// SPDX-License-Identifier: Apache-2.0
// Against Embree's robust mode on a mesh of 100,000 triangles: an intersector, a hierarchy and a
// way of rounding that share nothing with ours.
#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/trace_rig.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class EmbreeScene {
  public:
    explicit EmbreeScene(const Mesh& mesh)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* p = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size()));
        for (const glm::dvec3& v : mesh.positions)
            for (int axis = 0; axis < 3; ++axis) *p++ = float(v[axis]);
        auto* t = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
        for (const glm::uvec3& v : mesh.triangles)
            for (int corner = 0; corner < 3; ++corner) *t++ = v[corner];
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    TestHit nearest(const TestRay& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit r{};
        r.ray.org_x = ray.origin.x, r.ray.org_y = ray.origin.y, r.ray.org_z = ray.origin.z;
        r.ray.dir_x = ray.direction.x, r.ray.dir_y = ray.direction.y;
        r.ray.dir_z = ray.direction.z;
        r.ray.tfar = ray.reach;
        r.ray.mask = ~0u;
        r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &r);
        const bool met = r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        return {r.ray.tfar, r.hit.u, r.hit.v, met ? r.hit.primID : LOBE_NONE};
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

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
        const TestHit theirs = embree.nearest(rays[i]), ours = hits[i];
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
