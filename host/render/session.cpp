// SPDX-License-Identifier: Apache-2.0
#include "render/session.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/timer.h"
#include "cl/binary_cache.h"
#include "cl/kernel_args.h"

namespace lobe {
namespace {

// A launch's sums stay below this, so that large films need no large buffer.
constexpr std::size_t sums_bytes = 64u << 20;
// PoCL compiles anew for grids of 65,536 and more.
constexpr std::uint32_t grid_limit = 65528;
// Jobs that a launch may have even where the film has fewer tiles: they are further blocks.
constexpr std::uint32_t least_jobs = 256;

unsigned round_up(unsigned value, unsigned grain) { return (value + grain - 1) / grain * grain; }

std::uint32_t tile_count(const LobeFrame& frame) {
    return frame.tiles_across * ((frame.window_height + LOBE_TILE - 1) / LOBE_TILE);
}

}  // namespace

struct Session::Buffers {
    Buffers(const Device& d, const PackedScene& s, std::size_t tiles)
        : frame(d, std::size_t{1}, "frame"),
          nodes(d, s.bvh.nodes, "hierarchy"),
          triangle_leaves(d, s.bvh.triangle_leaves, "triangle leaves"),
          sphere_leaves(d, s.bvh.sphere_leaves, "sphere leaves"),
          triangles(d, s.triangles, "triangles"),
          vertices(d, s.vertices, "vertices"),
          spheres(d, s.spheres, "spheres"),
          surfaces(d, s.surfaces, "surfaces"),
          materials(d, s.materials, "materials"),
          rows(d, s.rows, "material parameters"),
          prepared(d, s.materials.size() * LOBE_PREPARED_BYTES, "prepared materials"),
          lights(d, s.lights.lights, "lights"),
          light_nodes(d, s.lights.nodes, "light tree"),
          tables(d, s.tables, "measured reflectance"),
          filter(d, s.filter_nodes, "filter table"),
          jobs(d, tiles, "tiles"),
          sums(d, tiles * tile_sums, "film"),
          status(d, std::vector<cl_uint>(LOBE_STATUS_COUNT, 0), "status"),
          statistics(d, tiles * LOBE_STATISTIC_COUNT, "statistics") {}

    Buffer<LobeFrame> frame;
    Buffer<LobeNode> nodes;
    Buffer<LobeTriangleLeaf> triangle_leaves;
    Buffer<LobeSphereLeaf> sphere_leaves;
    Buffer<LobeTriangle> triangles;
    Buffer<LobeVertex> vertices;
    Buffer<LobeSphere> spheres;
    Buffer<LobeSurface> surfaces;
    Buffer<LobeMaterial> materials;
    Buffer<LobeRow> rows;
    Buffer<cl_uchar> prepared;
    Buffer<LobeLight> lights;
    Buffer<LobeLightNode> light_nodes;
    Buffer<cl_float> tables;
    Buffer<cl_float> filter;
    Buffer<LobeTileJob> jobs;
    Buffer<LobeBlockSum> sums;
    Buffer<cl_uint> status;
    Buffer<cl_uint> statistics;  // LOBE_STATISTIC_COUNT a tile

    std::size_t bytes() const {
        return frame.bytes() + nodes.bytes() + triangle_leaves.bytes() + sphere_leaves.bytes() +
               triangles.bytes() + vertices.bytes() + spheres.bytes() + surfaces.bytes() +
               materials.bytes() + rows.bytes() + prepared.bytes() + lights.bytes() +
               light_nodes.bytes() + tables.bytes() + filter.bytes() + jobs.bytes() + sums.bytes() +
               status.bytes() + statistics.bytes();
    }
};

Session::Session(const Device& device, RenderKernel kernel, const PackedScene& scene,
                 Watchdog* watchdog)
    : device_(device), kernel_(std::move(kernel)), frame_(scene.frame) {
    upload(scene, watchdog);
}

Session::Session(const Device& device, const KernelText& kernels, const PackedScene& scene,
                 const SessionOptions& options)
    : Session(device, RenderKernel(device, kernels, scene, options), scene, options.watchdog) {}

Session::~Session() = default;

void Session::upload(const PackedScene& scene, Watchdog* watchdog) {
    const Stopwatch watch;
    const std::size_t limit = std::min<std::size_t>(sums_bytes, device_.info().largest_allocation) /
                              (tile_sums * sizeof(LobeBlockSum));
    max_tiles_ = static_cast<std::uint32_t>(std::clamp<std::size_t>(
        limit, 1, std::min(grid_limit / LOBE_TILE, std::max(tile_count(frame_), least_jobs))));
    buffers_ = std::make_unique<Buffers>(device_, scene, max_tiles_);
    prepare_materials(scene.materials.size(), watchdog);
    Buffers& b = *buffers_;
    set_args(kernel_.render, b.frame, b.nodes, b.triangle_leaves, b.sphere_leaves, b.triangles,
             b.vertices, b.spheres, b.surfaces, b.materials, b.prepared, b.lights, b.light_nodes,
             b.tables, b.filter, b.jobs, b.sums, b.status, b.statistics);
    upload_seconds_ = watch.seconds();
}

void Session::prepare_materials(std::size_t count, Watchdog* watchdog) {
    if (count == 0) return;
    Buffers& b = *buffers_;
    cl::Kernel prepare = kernel_.program.kernel("prepare");
    set_args(prepare, b.materials, b.rows, b.prepared, static_cast<cl_uint>(count), b.status);
    const Watchdog::Launch watched(watchdog, 0);
    launch(device_, prepare, cl::NDRange(count), cl::NDRange(1));
    device_.finish();
}

void Session::set_seed(std::uint64_t seed) {
    frame_.seed0 = static_cast<LobeUint>(seed);
    frame_.seed1 = static_cast<LobeUint>(seed >> 32);
}

void Session::render_tiles(const LobeTileJob* jobs, std::uint32_t count, std::uint32_t samples,
                           LobeBlockSum* sums) {
    frame_.tiles = count;
    frame_.samples = samples;
    buffers_->frame.write(&frame_, 1);
    buffers_->jobs.write(jobs, count);
    counters_.assign(std::size_t{count} * LOBE_STATISTIC_COUNT, 0);
    buffers_->statistics.write(counters_.data(), counters_.size());
    const auto [x, y] = kernel_.local;
    launch(device_, kernel_.render,
           cl::NDRange(round_up(LOBE_TILE, x), round_up(LOBE_TILE * count, y)), cl::NDRange(x, y));
    buffers_->sums.read(sums, count * tile_sums);
    buffers_->statistics.read(counters_.data(), counters_.size());
    statistics_.add(counters_);
}

RenderStatus Session::status() const {
    RenderStatus status;
    buffers_->status.read(status.counters.data(), status.counters.size());
    return status;
}

std::size_t Session::device_bytes() const { return buffers_->bytes(); }

std::optional<std::size_t> Session::private_bytes() const {
    // PoCL says 1024 of every kernel.
    const DeviceInfo& info = device_.info();
    if (info.platform == "Portable Computing Language" && info.type & CL_DEVICE_TYPE_CPU) return {};
    try {
        const auto bytes =
            kernel_.render.getWorkGroupInfo<CL_KERNEL_PRIVATE_MEM_SIZE>(device_.device());
        if (bytes > 0) return static_cast<std::size_t>(bytes);
    } catch (const cl::Error&) {
    }
    return {};
}

void Session::keep_program() const { save_binary(device_, kernel_.program); }

}  // namespace lobe
