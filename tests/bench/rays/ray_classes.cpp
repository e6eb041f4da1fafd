// SPDX-License-Identifier: Apache-2.0
#include "rays/ray_classes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "support/meshes.h"

namespace lobe::bench {
namespace {

using test::TestRay;

constexpr unsigned block_width = 4, block_height = 2;
constexpr float margin = 1e-4f;  // of the mesh's size

struct Box {
    glm::dvec3 low, high;
    glm::dvec3 middle() const { return 0.5 * (low + high); }
    double size() const { return glm::length(high - low); }
};

Box box_of(const Mesh& mesh) {
    Box box{mesh.positions.at(0), mesh.positions.at(0)};
    for (const glm::dvec3& p : mesh.positions) {
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
    return box;
}

// Where a ray met the mesh: a point just off the surface, and the normal on the ray's side.
struct Meeting {
    glm::vec3 point, normal;
};

std::vector<Meeting> meet(const Mesh& mesh, const test::EmbreeScene& embree,
                          const std::vector<TestRay>& rays) {
    const auto offset = static_cast<float>(margin * box_of(mesh).size());
    std::vector<Meeting> meetings;
    for (const TestRay& ray : rays) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit r = test::embree_ray(ray.origin, ray.direction);
        rtcIntersect1(embree.get(), &context, &r);
        if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
        glm::vec3 n = glm::normalize(glm::vec3(r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z));
        if (glm::dot(n, ray.direction) > 0) n = -n;
        meetings.push_back({ray.origin + r.ray.tfar * ray.direction + offset * n, n});
    }
    return meetings;
}

std::vector<TestRay> camera_rays(const Box& box, unsigned side) {
    const glm::dvec3 eye = box.middle() + glm::dvec3(0.1, -0.45, 0.3) * (box.high - box.low);
    const glm::dvec3 forward = glm::normalize(box.middle() - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
    const glm::dvec3 up = glm::cross(right, forward);
    std::vector<TestRay> rays;
    for (unsigned y = 0; y < side; y += block_height)
        for (unsigned x = 0; x < side; x += block_width)
            for (unsigned i = 0; i < block_width * block_height; ++i) {
                const double u = (x + i % block_width + 0.5) / side * 2 - 1;
                const double v = (y + i / block_width + 0.5) / side * 2 - 1;
                rays.push_back({eye, glm::normalize(forward + 0.7 * (u * right + v * up))});
            }
    return rays;
}

std::vector<TestRay> shadow_rays(const Box& box, const std::vector<Meeting>& from, Random& random) {
    const double half = 0.05 * box.size();
    const glm::dvec3 lamp = glm::mix(box.middle(), box.high, glm::dvec3(0.3, 0.2, 0.9));
    std::vector<TestRay> rays;
    for (const Meeting& m : from) {
        const glm::dvec3 way =
            lamp + half * glm::dvec3(random.uniform(), random.uniform(), 0) - glm::dvec3(m.point);
        if (glm::dot(way, glm::dvec3(m.normal)) <= 0) continue;
        const double distance = glm::length(way);
        rays.push_back({m.point, way / distance, static_cast<float>(0.9999 * distance)});
    }
    return rays;
}

std::vector<TestRay> cosine_rays(const std::vector<Meeting>& from, Random& random) {
    std::vector<TestRay> rays;
    for (const Meeting& m : from) {
        const glm::dvec3 way = glm::dvec3(m.normal) + 0.9999 * test::random_direction(random);
        rays.push_back({m.point, glm::normalize(way)});
    }
    return rays;
}

}  // namespace

std::vector<RayClass> ray_classes(const Mesh& mesh, const test::EmbreeScene& embree,
                                  unsigned side) {
    Random random(1);
    const Box box = box_of(mesh);
    std::vector<RayClass> classes;
    classes.push_back({"primary", false, camera_rays(box, side)});
    const auto first = meet(mesh, embree, classes[0].rays);
    classes.push_back({"shadow", true, shadow_rays(box, first, random)});
    classes.push_back({"bounce", false, cosine_rays(first, random)});
    const auto second = meet(mesh, embree, classes[2].rays);
    classes.push_back({"2nd bounce", false, cosine_rays(second, random)});
    return classes;
}

}  // namespace lobe::bench
