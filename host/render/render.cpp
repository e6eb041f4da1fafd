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
        : grain_(session.row_grain()), most_(session.max_rows()), seconds_(plan.launch_seconds),
          fixed_(plan.rows_per_launch) {
        // The first launch may carry the compilation: small, and its time is not counted.
        rows_ = std::clamp(grain_, 1u, most_);
    }

    std::uint32_t rows() const { return fixed_ ? std::min(fixed_, most_) : rows_; }

    void took(std::uint32_t rows, std::uint32_t samples, double seconds) {
        if (++launches_ == 1 || seconds <= 0) return;
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

}  // namespace

RenderOutcome render(Session& session, const RenderPlan& plan,
                     const std::function<void(const RenderProgress&)>& progress,
                     const std::function<bool()>& stop) {
    const Stopwatch watch;
    const std::uint32_t width = session.width(), height = session.height();
    RenderOutcome outcome{Film(width, height)};
    std::vector<LobeBlockSum> block(static_cast<std::size_t>(width) * height * LOBE_REPLICATES);
    LaunchSize size(session, plan);
    const double total = static_cast<double>(width) * height * plan.samples;

    for (std::uint32_t first = 0; first < plan.samples && !outcome.stopped; first += LOBE_BLOCK) {
        const std::uint32_t samples = std::min<std::uint32_t>(LOBE_BLOCK, plan.samples - first);
        std::uint32_t row = 0;
        while (row < height) {
            if (stop && stop()) {
                outcome.stopped = true;
                break;
            }
            const std::uint32_t rows = std::min(size.rows(), height - row);
            const Stopwatch launch;
            session.render_rows(first, samples, row, rows,
                                block.data() + static_cast<std::size_t>(row) * width * LOBE_REPLICATES);
            size.took(rows, samples, launch.seconds());
            row += rows;
            const double done = static_cast<double>(width) * (static_cast<double>(height) * first +
                                                              static_cast<double>(row) * samples);
            if (progress && row < height) progress({done, total, outcome.film, false});
        }
        if (row == height || (first == 0 && row > 0)) outcome.film.add_block(block, samples);
        if (progress && row == height)
            progress({static_cast<double>(width) * height * (first + samples), total, outcome.film, true});
    }
    outcome.seconds = watch.seconds();
    return outcome;
}

}  // namespace lobe
