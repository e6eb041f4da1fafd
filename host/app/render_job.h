// SPDX-License-Identifier: Apache-2.0
// A render from its first launch to its last line of output.
#pragma once

#include <optional>

#include "app/command.h"
#include "base/timer.h"
#include "render/render.h"
#include "report/image_io.h"
#include "report/render_report.h"

namespace lobe {

// What a render is asked to reach; the first of these ends it.
struct RenderGoals {
    std::uint32_t samples = 16;   // per pixel
    std::optional<double> error;  // relative standard error
    std::optional<double> time;   // seconds from the beginning of the command
    bool adaptive = false;
};

// How the results are written.
struct RenderOutputs {
    CommonOptions common;
    double exposure = 1;
    std::string html;  // a page of the render; "" for none
};

class RenderJob {
  public:
    // All that is given stays with the caller and outlives the job; `total` runs since the command
    // began.
    RenderJob(const RenderOutputs& outputs, RenderReport& report, const PackedScene& packed,
              ImageIo& images, const Stopwatch& total)
        : outputs_(outputs), report_(report), packed_(packed), images_(images), total_(total) {}

    // Renders until a goal is reached or a signal comes, and fills the report.
    void render(Session& session, const RenderGoals& goals, std::uint64_t seed, Watchdog& watchdog);

    // Writes pictures, texts and JSON.
    void write();

    // For the watchdog, while the other thread waits for a launch that never ends and cannot be
    // cancelled: the picture so far, and the end of the process.
    [[noreturn]] void end_hung(double seconds);

  private:
    void take(const Film& film, double seconds, bool stopped);
    void write_pictures();
    std::vector<float> adapt(const RenderGoals& goals, std::uint64_t seed, const RenderPlan& plan);

    const RenderOutputs& outputs_;
    RenderReport& report_;
    const PackedScene& packed_;
    ImageIo& images_;
    const Stopwatch& total_;
    Session* session_ = nullptr;
    const Film* film_ = nullptr;  // whole rounds
    Stopwatch rendering_;
};

}  // namespace lobe
