// SPDX-License-Identifier: Apache-2.0
// A scene on a device, ready to be asked for samples.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cl/buffer.h"
#include "render/render_kernel.h"
#include "render/statistics.h"
#include "render/watchdog.h"
#include "shared/status.h"

namespace lobe {

struct SessionOptions : KernelOptions {
    Watchdog* watchdog = nullptr;  // looks after the preparation of the materials
};

// The status counters of shared/status.h.
struct RenderStatus {
    std::array<std::uint32_t, LOBE_STATUS_COUNT> counters{};
    std::uint32_t nonfinite() const { return counters[LOBE_STATUS_NONFINITE]; }
    std::uint32_t negative() const { return counters[LOBE_STATUS_NEGATIVE]; }
    std::uint32_t trapped() const { return counters[LOBE_STATUS_TRAP]; }
    bool sound() const { return !nonfinite() && !negative() && !trapped(); }
};

class Session {
  public:
    // Uploads the scene and prepares its materials. The kernel is the scene's.
    Session(const Device& device, RenderKernel kernel, const PackedScene& scene,
            Watchdog* watchdog = nullptr);
    // Builds that kernel first.
    Session(const Device& device, const KernelText& kernels, const PackedScene& scene,
            const SessionOptions& options = {});
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    void set_seed(std::uint64_t seed);
    std::uint32_t width() const { return frame_.window_width; }
    std::uint32_t height() const { return frame_.window_height; }

    // The next `samples` samples, at most LOBE_BLOCK, of `count` tiles, at most max_tiles(), each
    // from its own first sample. Writes tile_sums sums a job, row by row; those of a tile's pixels
    // outside the window are undefined. One launch; waits.
    void render_tiles(const LobeTileJob* jobs, std::uint32_t count, std::uint32_t samples,
                      LobeBlockSum* sums);
    static constexpr std::size_t tile_sums = LOBE_TILE * LOBE_TILE * LOBE_REPLICATES;

    // Most tiles that one launch may have.
    std::uint32_t max_tiles() const { return max_tiles_; }

    RenderStatus status() const;
    // Of all samples so far.
    const RenderStatistics& statistics() const { return statistics_; }
    // Building the program and its first, empty launch.
    double compile_seconds() const { return kernel_.seconds; }
    double upload_seconds() const { return upload_seconds_; }
    bool compiled_from_cache() const { return kernel_.program.cached; }
    std::size_t device_bytes() const;

    // What the device tells of the kernel, if it does: bytes of private memory that a work-item
    // has, and of the program's binary, asking for which may cost a compilation.
    std::optional<std::size_t> private_bytes() const;
    std::optional<std::size_t> binary_bytes() const { return lobe::binary_bytes(kernel_.program); }

    // Keeps the compiled program for later runs where that pays; call it after the render.
    void keep_program() const;

  private:
    struct Buffers;
    void upload(const PackedScene& scene, Watchdog* watchdog);
    void prepare_materials(std::size_t count, Watchdog* watchdog);

    const Device& device_;
    RenderKernel kernel_;
    LobeFrame frame_;
    std::unique_ptr<Buffers> buffers_;
    std::vector<std::uint32_t> counters_;  // of the tiles of a launch
    RenderStatistics statistics_;
    std::uint32_t max_tiles_ = 0;
    double upload_seconds_ = 0;
};

}  // namespace lobe
