// SPDX-License-Identifier: Apache-2.0
// The tracers that are measured, each with two threads or more at work on one class of rays.
#pragma once

#include <memory>

#include "rays/ray_classes.h"

namespace lobe::bench {

// What a pass over a class of rays found and took.
struct Pass {
    double seconds = 0;
    std::size_t met = 0;  // rays that met something
};

class Tracer {
  public:
    explicit Tracer(std::string name) : name_(std::move(name)) {}
    virtual ~Tracer() = default;
    const std::string& name() const { return name_; }
    // Rays in the order given; only what traversal takes is timed.
    virtual Pass trace(const RayClass& rays) = 0;

  private:
    std::string name_;
};

// Our kernels on the test device. Packs the mesh as the renderer does.
class LobeScene {
  public:
    explicit LobeScene(const Mesh& mesh);
    std::size_t bytes() const;

    std::size_t triangles;
    Buffer<LobeNode> nodes;
    Buffer<LobeTriangleLeaf> leaves;
    Buffer<LobeSphereLeaf> no_spheres;

  private:
    LobeScene(const Bvh& bvh, std::size_t triangles);
};

// Single rays, or, but for shadow rays, packets of eight where the rays run alike. `header` goes
// before the scene's own in the kernel.
enum class LobeCall { single, packets };
std::unique_ptr<Tracer> lobe_tracer(std::string name, const LobeScene& scene, LobeCall call,
                                    const std::string& header = "");

enum class EmbreeCall { single, packets };  // packets of 8, told to be coherent

std::unique_ptr<Tracer> embree_tracer(std::string name, const test::EmbreeScene& scene,
                                      EmbreeCall call);

}  // namespace lobe::bench
