// SPDX-License-Identifier: Apache-2.0
// A scene on a device, ready to be asked for samples.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "build/pack.h"
#include "cl/buffer.h"
#include "cl/program.h"
#include "render/statistics.h"
#include "render/watchdog.h"
#include "shared/status.h"

namespace lobe {

class KernelText;

struct SessionOptions {
    bool double_precision = false;        // the oracle build
    std::array<unsigned, 2> local{8, 8};  // work-group: any gives the same bits
    unsigned abreast = 0;  // samples that a work-item takes side by side, 1 or 8 with the same
                           // bits; 0: what suits the device
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
    // Builds the kernel for the scene, uploads the scene and prepares its materials.
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
    double compile_seconds() const { return program_.build_seconds + warm_up_seconds_; }
    double upload_seconds() const { return upload_seconds_; }
    bool compiled_from_cache() const { return program_.cached; }
    std::size_t device_bytes() const;

    // What the device tells of the kernel, if it does: bytes of private memory that a work-item
    // has, and of the program's binary, asking for which may cost a compilation.
    std::optional<std::size_t> private_bytes() const;
    std::optional<std::size_t> binary_bytes() const { return lobe::binary_bytes(program_); }

    // Keeps the compiled program for later runs where that pays; call it after the render.
    void keep_program() const;

  private:
    struct Buffers;
    void upload(const PackedScene& scene);
    void prepare_materials(std::size_t count);
    void fit_work_group();
    void warm_up();

    const Device& device_;
    SessionOptions options_;
    LobeFrame frame_;
    Program program_;
    cl::Kernel render_;
    std::unique_ptr<Buffers> buffers_;
    std::vector<std::uint32_t> counters_;  // of the tiles of a launch
    RenderStatistics statistics_;
    std::uint32_t max_tiles_ = 0;
    double upload_seconds_ = 0, warm_up_seconds_ = 0;
};

}  // namespace lobe
