// SPDX-License-Identifier: Apache-2.0
// The same mesh in Embree, to be compared with.
#pragma once

#include <embree3/rtcore.h>

#include "scene/scene.h"

namespace lobe::test {

enum class EmbreeMode { fast, robust };

class EmbreeScene {
  public:
    explicit EmbreeScene(const Mesh& mesh, EmbreeMode mode = EmbreeMode::robust);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene get() const { return scene_; }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

// A ray of unlimited reach, unless told otherwise, that has met nothing.
RTCRayHit embree_ray(const glm::vec3& origin, const glm::vec3& direction, float reach = 1e30f);

}  // namespace lobe::test
