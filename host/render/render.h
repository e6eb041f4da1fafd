// SPDX-License-Identifier: Apache-2.0
// The render loop: blocks of samples, each in launches short enough to be stopped between.
#pragma once

#include <functional>

#include "render/film.h"
#include "render/session.h"

namespace lobe {

struct RenderPlan {
    std::uint32_t samples = 16;         // per pixel
    std::uint32_t rows_per_launch = 0;  // 0: chosen by the clock; any gives the same bits
    double launch_seconds = 0.2;        // aim of that choice: how long a signal may wait
    Watchdog* watchdog = nullptr;       // looks after every launch, if there is one
};

struct RenderProgress {
    double samples_done, samples_total;  // over all pixels
    const Film& film;                    // complete blocks
    bool block_ended;
};

struct RenderOutcome {
    Film film;
    bool stopped = false;  // by the caller, before all samples were done
    double seconds = 0;
};

// Renders until the plan is done or `stop()` says so. Then the film ends at a block's border; only
// if not even the first block is complete does it hold that part of it that is (missing rows are
// 0), or nothing.
RenderOutcome render(Session& session, const RenderPlan& plan,
                     const std::function<void(const RenderProgress&)>& progress = {},
                     const std::function<bool()>& stop = {});

}  // namespace lobe
