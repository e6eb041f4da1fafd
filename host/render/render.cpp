// SPDX-License-Identifier: Apache-2.0
#include "render/render.h"

#include <algorithm>
#include <cmath>

#include "base/timer.h"

namespace lobe {
namespace {

// How many rows the next launch gets, so that launches last about as long as asked.
class LaunchSize {
  public:
    LaunchSize(const Session& session, const RenderPlan& plan)
        : grain_(session.row_grain()),
          most_(session.max_rows()),
          seconds_(plan.launch_seconds),
          fixed_(plan.rows_per_launch) {}

    std::uint32_t rows() const { return fixed_ ? std::min(fixed_, most_) : rows_; }

    void took(std::uint32_t rows, std::uint32_t samples, double seconds) {
        // The first launch may carry the compilation: one row, and its time is not counted.
        if (++launches_ == 1) rows_ = std::clamp(grain_, 1u, most_);
        if (launches_ == 1 || seconds <= 0) return;
        const double per_row = seconds / (static_cast<double>(rows) * samples) * LOBE_BLOCK;
        const double wanted = std::min(seconds_ / per_row, 4.0 * rows_);  // grow step by step
        const double rounded = std::ceil(wanted / grain_) * grain_;
        rows_ = static_cast<std::uint32_t>(std::clamp<double>(rounded, 1, most_));
    }

  private:
    std::uint32_t grain_, most_;
    double seconds_;
    std::uint32_t fixed_, rows_ = 1;
    unsigned launches_ = 0;
};

// One render in the making: what its blocks share.
struct Work {
    Session& session;
    const RenderPlan& plan;
    const std::function<void(const RenderProgress&)>& progress;
    const std::function<bool()>& stop;
    LaunchSize size;
    std::vector<LobeBlockSum> sums;
    RenderOutcome outcome;

    void report(double rows, std::uint32_t first, std::uint32_t samples, bool block_ended) {
        if (!progress) return;
        const double width = session.width(), height = session.height();
        progress({width * (height * first + rows * samples), width * height * plan.samples,
                  outcome.film, block_ended});
    }

    // Samples [first, first + samples) of all rows, or of those before a stop. Returns how many
    // rows.
    std::uint32_t render_block(std::uint32_t first, std::uint32_t samples) {
        const std::size_t row_sums = static_cast<std::size_t>(session.width()) * LOBE_REPLICATES;
        std::uint32_t row = 0;
        while (row < session.height()) {
            outcome.stopped = stop && stop();
            if (outcome.stopped) break;
            const std::uint32_t rows = std::min(size.rows(), session.height() - row);
            const Stopwatch launch;
            {
                const Watchdog::Launch watched(plan.watchdog,
                                               double{rows} * session.width() * samples);
                session.render_rows(first, samples, row, rows, sums.data() + row * row_sums);
            }
            size.took(rows, samples, launch.seconds());
            row += rows;
            if (row < session.height()) report(row, first, samples, false);
        }
        return row;
    }
};

}  // namespace

RenderOutcome render(Session& session, const RenderPlan& plan,
                     const std::function<void(const RenderProgress&)>& progress,
                     const std::function<bool()>& stop) {
    const Stopwatch watch;
    const std::size_t pixels = static_cast<std::size_t>(session.width()) * session.height();
    Work work{session,
              plan,
              progress,
              stop,
              LaunchSize(session, plan),
              std::vector<LobeBlockSum>(pixels * LOBE_REPLICATES),
              RenderOutcome{Film(session.width(), session.height())}};
    Film& film = work.outcome.film;
    for (std::uint32_t first = 0; first < plan.samples && !work.outcome.stopped;
         first += LOBE_BLOCK) {
        const std::uint32_t samples = std::min<std::uint32_t>(LOBE_BLOCK, plan.samples - first);
        const std::uint32_t rows = work.render_block(first, samples);
        const bool whole = rows == session.height();
        if (!whole && (first > 0 || rows == 0)) break;  // the film ends at the last whole block
        film.add_block(work.sums, samples);
        if (!whole) film.mark_incomplete();
        if (whole) work.report(rows, first, samples, true);
    }
    work.outcome.seconds = watch.seconds();
    return std::move(work.outcome);
}

}  // namespace lobe
