// SPDX-License-Identifier: Apache-2.0
#include "rays/tracers.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <thread>

#include "base/timer.h"

namespace lobe::bench {
namespace {

constexpr std::size_t group = 64;  // work-items; rays are padded to whole groups

// A class of rays on the device.
struct DeviceRays {
    explicit DeviceRays(const RayClass& rays)
        : count(rays.rays.size()),
          padded((count + group - 1) / group * group),
          numbers(test::test_device(), packed_numbers(rays, padded)),
          names(test::test_device(), std::vector<cl_uint>(2 * padded, LOBE_NONE)),
          out(test::test_device(), 3 * padded),
          primitives(test::test_device(), padded) {}

    static std::vector<float> packed_numbers(const RayClass& rays, std::size_t padded) {
        std::vector<float> n;
        n.reserve(8 * padded);
        for (std::size_t i = 0; i < padded; ++i) {
            const test::TestRay& r = rays.rays[std::min(i, rays.rays.size() - 1)];
            n.insert(n.end(), {r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y,
                               r.direction.z, r.reach, 0});
        }
        return n;
    }

    std::size_t count, padded;
    Buffer<float> numbers;
    Buffer<cl_uint> names;
    Buffer<float> out;
    Buffer<cl_uint> primitives;
};

std::string triangles_only(std::size_t triangles) {
    FeatureSet features = all_features();
    for (FeatureState& state : features)
        if (state.name == "SPHERES" || (state.name == "FETCH_AHEAD" && !outgrows_caches(triangles)))
            state.in = false;
    return scene_header(features, {});
}

class OurTracer : public Tracer {
  public:
    OurTracer(std::string name, const LobeScene& scene, LobeCall call, const std::string& header)
        : Tracer(std::move(name)),
          scene_(scene),
          call_(call),
          program_(test::build_probe(
              "probe/geom.cl", {{"lobe_scene.h", header + triangles_only(scene.triangles)}})) {}

    Pass trace(const RayClass& rays) override {
        auto found = rays_.find(rays.name);
        if (found == rays_.end()) found = rays_.emplace(rays.name, rays).first;
        DeviceRays& in = found->second;
        const bool together = call_ == LobeCall::packets && !rays.any;
        cl::Kernel kernel = program_.kernel(rays.any   ? "geom_occluded"
                                            : together ? "geom_nearest_together"
                                                       : "geom_nearest");
        if (rays.any)
            set_args(kernel, scene_.nodes, scene_.leaves, scene_.no_spheres, in.numbers, in.names,
                     in.primitives);
        else
            set_args(kernel, scene_.nodes, scene_.leaves, scene_.no_spheres, in.numbers, in.names,
                     in.out, in.primitives);
        const Device& device = test::test_device();
        const Stopwatch watch;
        launch(device, kernel, cl::NDRange(together ? in.padded / 8 : in.padded),
               cl::NDRange(together ? group / 8 : group));
        device.finish();
        Pass pass{watch.seconds(), 0};
        const std::vector<cl_uint> met = in.primitives.read_all();
        for (std::size_t i = 0; i < in.count; ++i) pass.met += met[i] != (rays.any ? 0 : LOBE_NONE);
        return pass;
    }

  private:
    const LobeScene& scene_;
    LobeCall call_;
    Program program_;
    std::map<std::string, DeviceRays> rays_;
};

class EmbreeTracer : public Tracer {
  public:
    EmbreeTracer(std::string name, const test::EmbreeScene& scene, EmbreeCall call)
        : Tracer(std::move(name)), scene_(scene), call_(call) {}

    Pass trace(const RayClass& rays) override {
        const std::size_t count = rays.rays.size();
        distance_.resize(count + 8);
        primitive_.resize(count + 8);
        std::atomic<std::size_t> next{0};
        const auto work = [&] {
            constexpr std::size_t chunk = 1024;
            for (std::size_t first; (first = next.fetch_add(chunk)) < count;) {
                const std::size_t last = std::min(first + chunk, count);
                if (call_ == EmbreeCall::packets && !rays.any)
                    for (std::size_t i = first; i < last; i += 8) packet(rays, i, last);
                else
                    for (std::size_t i = first; i < last; ++i) single(rays, i);
            }
        };
        const Stopwatch watch;
        std::vector<std::thread> threads;
        for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
            threads.emplace_back(work);
        work();
        for (std::thread& thread : threads) thread.join();
        Pass pass{watch.seconds(), 0};
        for (std::size_t i = 0; i < count; ++i) pass.met += primitive_[i] != LOBE_NONE;
        return pass;
    }

  private:
    void single(const RayClass& rays, std::size_t i) {
        const test::TestRay& ray = rays.rays[i];
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit r = test::embree_ray(ray.origin, ray.direction, ray.reach);
        if (rays.any) {
            rtcOccluded1(scene_.get(), &context, &r.ray);
            primitive_[i] = r.ray.tfar < 0 ? 0 : LOBE_NONE;
        } else {
            rtcIntersect1(scene_.get(), &context, &r);
            distance_[i] = r.ray.tfar;
            primitive_[i] = r.hit.geomID == RTC_INVALID_GEOMETRY_ID ? LOBE_NONE : r.hit.primID;
        }
    }

    void packet(const RayClass& rays, std::size_t first, std::size_t last) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        alignas(32) RTCRayHit8 r{};
        alignas(32) int valid[8];
        for (std::size_t k = 0; k < 8; ++k) {
            valid[k] = first + k < last ? -1 : 0;
            const test::TestRay& ray = rays.rays[std::min(first + k, last - 1)];
            r.ray.org_x[k] = ray.origin.x, r.ray.org_y[k] = ray.origin.y;
            r.ray.org_z[k] = ray.origin.z, r.ray.dir_x[k] = ray.direction.x;
            r.ray.dir_y[k] = ray.direction.y, r.ray.dir_z[k] = ray.direction.z;
            r.ray.tfar[k] = ray.reach, r.ray.mask[k] = ~0u;
            r.hit.geomID[k] = r.hit.primID[k] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect8(valid, scene_.get(), &context, &r);
        for (std::size_t k = 0; first + k < last; ++k) {
            if (k == 8) break;
            distance_[first + k] = r.ray.tfar[k];
            primitive_[first + k] = r.hit.primID[k];
        }
    }

    const test::EmbreeScene& scene_;
    EmbreeCall call_;
    std::vector<float> distance_;
    std::vector<std::uint32_t> primitive_;
};

Bvh bvh_of(const Mesh& mesh) {
    std::vector<LobeTriangle> triangles;
    std::vector<LobeVertex> vertices;
    for (const glm::dvec3& p : mesh.positions)
        vertices.push_back({float(p.x), float(p.y), float(p.z), 0, 0, 0, 0, 0});
    for (const glm::uvec3& t : mesh.triangles) triangles.push_back({t.x, t.y, t.z, 0});
    return build_bvh(triangles, vertices, {});
}

}  // namespace

LobeScene::LobeScene(const Mesh& mesh) : LobeScene(bvh_of(mesh), mesh.triangles.size()) {}

LobeScene::LobeScene(const Bvh& bvh, std::size_t count)
    : triangles(count),
      nodes(test::test_device(), bvh.nodes),
      leaves(test::test_device(), bvh.triangle_leaves),
      no_spheres(test::test_device(), std::vector<LobeSphereLeaf>()) {}

std::size_t LobeScene::bytes() const {
    return nodes.count() * sizeof(LobeNode) + leaves.count() * sizeof(LobeTriangleLeaf);
}

std::unique_ptr<Tracer> lobe_tracer(std::string name, const LobeScene& scene, LobeCall call,
                                    const std::string& header) {
    return std::make_unique<OurTracer>(std::move(name), scene, call, header);
}

std::unique_ptr<Tracer> embree_tracer(std::string name, const test::EmbreeScene& scene,
                                      EmbreeCall call) {
    return std::make_unique<EmbreeTracer>(std::move(name), scene, call);
}

}  // namespace lobe::bench
