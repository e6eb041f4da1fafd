// SPDX-License-Identifier: Apache-2.0
// The render loop: rounds of blocks of samples, each in launches short enough to be stopped
// between.
#pragma once

#include <functional>
#include <vector>

#include "render/film.h"
#include "render/session.h"

namespace lobe {

struct RenderProgress {
    double samples_done, samples_total;  // over all pixels
    const Film& film;                    // whole rounds
    bool round_ended;
};

struct RenderPlan {
    std::uint32_t samples = 16;          // per pixel; with rates, in the mean
    std::uint32_t tiles_per_launch = 0;  // 0: chosen by the clock; any gives the same bits
    double launch_seconds = 0.2;         // aim of that choice: how long a signal may wait
    Watchdog* watchdog = nullptr;        // looks after every launch, if there is one

    // How much more than the mean each tile of the film gets; empty: all the same. To keep the
    // picture unbiased they must not depend on the samples that this render takes.
    std::vector<float> rates;

    // Asked before every launch: whether to stop now, at a signal for example. A round that is
    // under way is lost, but for the first.
    std::function<bool()> stop;
    // Asked before every round: how many of the next `wanted` samples to take. Less than a block
    // are the last; 0 ends the render.
    std::function<std::uint32_t(const Film& film, std::uint32_t wanted)> next_samples;
    std::function<void(const RenderProgress&)> progress;
};

struct RenderOutcome {
    Film film;
    bool stopped = false;  // by plan.stop, before all samples were done
    double seconds = 0;
};

// Renders until the plan is done or ends it. After a stop the film ends at a round's border; only
// if not even the first round is complete does it hold those tiles of it that are, the others
// having no sample.
RenderOutcome render(Session& session, const RenderPlan& plan);

// Seconds that one sample of every pixel takes, measured on a small part of the film.
double measure_pace(Session& session);

}  // namespace lobe
