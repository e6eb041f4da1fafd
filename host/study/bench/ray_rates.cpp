// SPDX-License-Identifier: Apache-2.0
#include "study/bench/ray_rates.h"

#include <algorithm>

#include "base/statistics.h"
#include "base/timer.h"
#include "cl/buffer.h"
#include "cl/kernel_args.h"
#include "cl/program.h"
#include "cl/source.h"
#include "render/lanes.h"
#include "shared/bench.h"

namespace lobe {
namespace {

constexpr std::size_t group = 64;  // work-items
constexpr std::size_t packet = 8;  // rays that may be traced together

std::size_t round_up(std::size_t value, std::size_t grain) {
    return (value + grain - 1) / grain * grain;
}

// The scene's shapes and lights on the device.
struct SceneBuffers {
    SceneBuffers(const Device& d, const PackedScene& s)
        : nodes(d, s.bvh.nodes),
          triangle_leaves(d, s.bvh.triangle_leaves),
          sphere_leaves(d, s.bvh.sphere_leaves),
          triangles(d, s.triangles),
          vertices(d, s.vertices),
          spheres(d, s.spheres),
          surfaces(d, s.surfaces),
          lights(d, s.lights.lights),
          light_nodes(d, s.lights.nodes),
          filter(d, s.filter_nodes),
          frame(d, std::vector<LobeFrame>{s.frame}) {}

    Buffer<LobeNode> nodes;
    Buffer<LobeTriangleLeaf> triangle_leaves;
    Buffer<LobeSphereLeaf> sphere_leaves;
    Buffer<LobeTriangle> triangles;
    Buffer<LobeVertex> vertices;
    Buffer<LobeSphere> spheres;
    Buffer<LobeSurface> surfaces;
    Buffer<LobeLight> lights;
    Buffer<LobeLightNode> light_nodes;
    Buffer<cl_float> filter;
    Buffer<LobeFrame> frame;
};

// Rays of one kind, those that exist, and room for what they meet.
struct Rays {
    Rays(const Device& device, std::vector<LobeBenchRay> all)
        : count(all.size()), rays(device, all), hits(device, std::max<std::size_t>(count, 1)) {}

    std::size_t count;
    Buffer<LobeBenchRay> rays;
    Buffer<LobeBenchHit> hits;
};

class RayBench {
  public:
    RayBench(const Device& device, const KernelText& kernels, const PackedScene& scene)
        : device_(device), scene_(scene), buffers_(device, scene) {
        const std::string header =
            scene_header(scene.features, {}, scene.integrator, suitable_lanes(device.info()));
        program_ =
            build_program(device, flatten(kernels, "bench/rays.cl", {{"lobe_scene.h", header}}));
    }

    Rays camera_rays(std::size_t count) {
        Buffer<LobeBenchRay> rays(device_, count);
        run("bench_camera", count, buffers_.frame, buffers_.filter, cl_uint(count), rays);
        return Rays(device_, rays.read_all());
    }

    // Rays that leave what `from` met, after a trace of it.
    struct Followers {
        Rays shadows, bounces;
    };
    Followers follow(const Rays& from, cl_uint depth) {
        trace("bench_nearest", from);
        Buffer<LobeBenchRay> shadows(device_, from.count), bounces(device_, from.count);
        run("bench_follow", from.count, buffers_.triangles, buffers_.vertices, buffers_.spheres,
            buffers_.surfaces, cl_uint(scene_.triangles.size()), buffers_.lights,
            buffers_.light_nodes, cl_uint(scene_.lights.lights.size()), cl_uint(scene_.lights.root),
            depth, cl_uint(from.count), from.rays, from.hits, shadows, bounces);
        return {existing(shadows), existing(bounces)};
    }

    RayRate measure(const std::string& name, const std::string& kernel, const Rays& rays,
                    unsigned repeats) {
        RayRate result;
        result.name = name;
        result.rays = rays.count;
        std::vector<double> rates;
        for (unsigned i = 0; i <= repeats; ++i) {
            const double seconds = trace(kernel, rays);
            if (i > 0) rates.push_back(double(rays.count) / seconds);
        }
        result.rate = median(rates);
        result.rate_deviation = deviation_from(rates, result.rate);
        for (const LobeBenchHit& hit : rays.hits.read_all())
            result.met += (hit.primitive != LOBE_NONE) / double(rays.count);
        return result;
    }

  private:
    // Seconds of one launch.
    double trace(const std::string& kernel, const Rays& rays) {
        const std::size_t items =
            kernel == "bench_together" ? (rays.count + packet - 1) / packet : rays.count;
        return run(kernel, items, buffers_.nodes, buffers_.triangle_leaves, buffers_.sphere_leaves,
                   cl_uint(rays.count), rays.rays, rays.hits);
    }

    template <typename... Args>
    double run(const std::string& name, std::size_t items, const Args&... args) {
        cl::Kernel kernel = program_.kernel(name);
        set_args(kernel, args...);
        const Stopwatch watch;
        launch(device_, kernel, cl::NDRange(round_up(items, group)), cl::NDRange(group));
        device_.finish();
        return watch.seconds();
    }

    Rays existing(const Buffer<LobeBenchRay>& all) const {
        std::vector<LobeBenchRay> rays = all.read_all();
        rays.erase(std::remove_if(rays.begin(), rays.end(), [](auto& r) { return !r.exists; }),
                   rays.end());
        rays.resize(rays.size() / packet * packet);
        return Rays(device_, std::move(rays));
    }

    const Device& device_;
    const PackedScene& scene_;
    SceneBuffers buffers_;
    Program program_;
};

}  // namespace

std::vector<RayRate> measure_rays(const Device& device, const KernelText& kernels,
                                  const PackedScene& scene, const RayPlan& plan,
                                  const std::function<bool()>& stop) {
    RayBench bench(device, kernels, scene);
    const Rays camera = bench.camera_rays(round_up(plan.rays, packet));
    const auto first = bench.follow(camera, 0);
    const auto second = bench.follow(first.bounces, 1);
    struct Kind {
        const char *name, *kernel;
        const Rays* rays;
    };
    const Kind kinds[] = {{"camera", "bench_nearest", &camera},
                          {"camera, eight together", "bench_together", &camera},
                          {"shadow", "bench_any", &first.shadows},
                          {"bounce", "bench_nearest", &first.bounces},
                          {"second bounce", "bench_nearest", &second.bounces}};
    std::vector<RayRate> rates;
    for (const Kind& kind : kinds) {
        if (stop && stop()) break;
        if (kind.rays->count > 0)
            rates.push_back(bench.measure(kind.name, kind.kernel, *kind.rays, plan.repeats));
    }
    return rates;
}

}  // namespace lobe
