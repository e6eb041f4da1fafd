// SPDX-License-Identifier: Apache-2.0
// Rays on the device through shapes packed as the renderer packs them (kernels/probe/geom.cl).
#pragma once

#include <vector>

#include "build/pack.h"
#include "support/probe.h"

namespace lobe::test {

struct TestRay {
    glm::vec3 origin, direction;
    float reach = 1e30f;
    std::uint32_t from = LOBE_NONE, target = LOBE_NONE;
};

struct TestHit {
    float distance, b1, b2;
    std::uint32_t primitive;
    bool operator==(const TestHit& o) const {
        return distance == o.distance && b1 == o.b1 && b2 == o.b2 && primitive == o.primitive;
    }
    // Spheres have no weights: b1 and b2 mean nothing there.
    bool same(const TestHit& o, std::size_t triangles) const {
        return primitive < triangles ? *this == o
                                     : distance == o.distance && primitive == o.primitive;
    }
};

struct LeavingRay {
    TestRay ray;
    float shift;  // of its origin from the surface
};

// A scene of the given shapes without lights, a camera at their middle.
Scene scene_of(std::vector<Shape> shapes);
Shape shape_of(Mesh mesh);
Shape shape_of(Sphere sphere);

// Each ray by itself, or eight after eight together: then as many as make whole eights.
enum class Traversal { alone, together };

class TraceRig {
  public:
    // Render space is the shapes' own space: nothing is moved or scaled.
    explicit TraceRig(const Mesh& mesh, const std::vector<Sphere>& spheres = {});
    // As place_scene wants it.
    explicit TraceRig(const Scene& scene);

    const PackedScene& packed() const { return packed_; }

    std::vector<TestHit> nearest(const Program& program, const std::vector<TestRay>& rays,
                                 Traversal traversal = Traversal::alone) const;
    std::vector<TestHit> linear(const Program& program, const std::vector<TestRay>& rays) const;
    std::vector<std::uint32_t> occluded(const Program& program,
                                        const std::vector<TestRay>& rays) const;
    // Rays that leave what the given rays meet, along `ways`; from LOBE_NONE: nothing was met.
    std::vector<LeavingRay> leave(const Program& program, const std::vector<TestRay>& rays,
                                  const std::vector<glm::vec3>& ways) const;

  private:
    void upload();

    PackedScene packed_;
    std::vector<Buffer<LobeNode>> nodes_;
    std::vector<Buffer<LobeTriangleLeaf>> triangle_leaves_;
    std::vector<Buffer<LobeSphereLeaf>> sphere_leaves_;
};

// The probe as the renderer is built; `header` goes before lobe_scene.h, `texts` replaces files.
Program build_trace_probe(const std::string& header = "", Texts texts = {});

}  // namespace lobe::test
