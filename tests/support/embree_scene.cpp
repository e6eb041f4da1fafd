// SPDX-License-Identifier: Apache-2.0
#include "support/embree_scene.h"

namespace lobe::test {

EmbreeScene::EmbreeScene(const Mesh& mesh, EmbreeMode mode)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    if (mode == EmbreeMode::robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
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

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

RTCRayHit embree_ray(const glm::vec3& origin, const glm::vec3& direction, float reach) {
    RTCRayHit r{};
    r.ray.org_x = origin.x, r.ray.org_y = origin.y, r.ray.org_z = origin.z;
    r.ray.dir_x = direction.x, r.ray.dir_y = direction.y, r.ray.dir_z = direction.z;
    r.ray.tfar = reach;
    r.ray.mask = ~0u;
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return r;
}

}  // namespace lobe::test
