// SPDX-License-Identifier: Apache-2.0
#include "render/render.h"

#include <algorithm>
#include <cmath>

#include "base/timer.h"

namespace lobe {
namespace {

// How many tiles the next launch gets, so that launches last about as long as asked.
class LaunchSize {
  public:
    LaunchSize(const Session& session, const RenderPlan& plan)
        : most_(session.max_tiles()),
          seconds_(plan.launch_seconds),
          fixed_(plan.tiles_per_launch) {}

    std::uint32_t tiles() const { return std::min(fixed_ ? fixed_ : tiles_, most_); }

    void took(std::uint32_t tiles, std::uint32_t samples, double seconds) {
        // The first launch may carry the compilation: its time is not counted.
        if (++launches_ == 1 || seconds <= 0) return;
        const double per_tile = seconds / (static_cast<double>(tiles) * samples) * LOBE_BLOCK;
        const double wanted = std::min(seconds_ / per_tile, 4.0 * tiles_);  // grow step by step
        tiles_ = static_cast<std::uint32_t>(std::clamp<double>(std::ceil(wanted), 1, most_));
    }

  private:
    std::uint32_t most_;
    double seconds_;
    std::uint32_t fixed_, tiles_ = 1;
    unsigned launches_ = 0;
};

// Samples a pixel of the next round. Small films take several blocks at once, so that a device has
// enough to do; but never many more than there are already, since a render can only end on a
// round.
std::uint32_t round_samples(std::uint32_t taken, std::uint32_t tiles) {
    const std::uint32_t most = std::max(1u, 256 / std::max(tiles, 1u));
    return LOBE_BLOCK * std::clamp(taken / LOBE_BLOCK / 16, 1u, most);
}

// As many whole blocks as there are; what is less than one stays.
std::uint32_t whole_blocks(std::uint32_t samples) {
    return samples < LOBE_BLOCK ? samples : samples / LOBE_BLOCK * LOBE_BLOCK;
}

// One render in the making: what its rounds share.
class Work {
  public:
    Work(Session& session, const RenderPlan& plan)
        : session_(session),
          plan_(plan),
          size_(session, plan),
          outcome_{Film(session.width(), session.height())} {}

    RenderOutcome run() {
        const Stopwatch watch;
        Film& film = outcome_.film;
        for (std::uint32_t taken = 0; taken < plan_.samples && !outcome_.stopped;) {
            const std::uint32_t wanted =
                whole_blocks(std::min(round_samples(taken, film.tiles()), plan_.samples - taken));
            const std::uint32_t samples =
                plan_.next_samples
                    ? whole_blocks(std::min(plan_.next_samples(film, wanted), wanted))
                    : wanted;
            if (samples == 0) break;
            const std::size_t whole = render_round(taken, samples);
            // The film ends at the last whole round, if there is one.
            if (whole == jobs_.size() || taken == 0)
                for (std::size_t i = 0; i < whole; ++i)
                    film.add_tile(jobs_[i].tile, &sums_[i * Session::tile_sums],
                                  std::min<std::uint32_t>(samples, LOBE_BLOCK));
            taken += samples;
            if (whole == jobs_.size()) report(taken, 0, samples, true);
            if (samples < LOBE_BLOCK) break;
        }
        outcome_.seconds = watch.seconds();
        return std::move(outcome_);
    }

  private:
    // The blocks that tiles take while the mean goes from `taken` to `taken + samples`: at least
    // one in the first round, and as many in all as their rates ask.
    void list_jobs(std::uint32_t taken, std::uint32_t samples) {
        jobs_.clear();
        for (std::uint32_t t = 0; t < outcome_.film.tiles(); ++t) {
            const std::uint32_t done = outcome_.film.tile_samples(t);
            std::uint32_t due = taken + samples;
            if (!plan_.rates.empty() && samples >= LOBE_BLOCK)
                due = LOBE_BLOCK *
                      std::max<std::uint32_t>(1, std::lround(plan_.rates[t] * due / LOBE_BLOCK));
            if (!plan_.rates.empty() && samples < LOBE_BLOCK) due = done + samples;
            for (std::uint32_t first = done; first < due; first += LOBE_BLOCK)
                jobs_.push_back({t, first});
        }
        sums_.resize(jobs_.size() * Session::tile_sums);
    }

    // Returns how many jobs were done before a stop.
    std::size_t render_round(std::uint32_t taken, std::uint32_t samples) {
        list_jobs(taken, samples);
        const std::uint32_t each = std::min<std::uint32_t>(samples, LOBE_BLOCK);
        std::size_t done = 0;
        while (done < jobs_.size()) {
            outcome_.stopped = plan_.stop && plan_.stop();
            if (outcome_.stopped) break;
            const auto count = static_cast<std::uint32_t>(
                std::min<std::size_t>(size_.tiles(), jobs_.size() - done));
            const double tile_pixels = LOBE_TILE * LOBE_TILE;
            const Stopwatch launch;
            {
                const Watchdog::Launch watched(plan_.watchdog, tile_pixels * count * each);
                session_.render_tiles(&jobs_[done], count, each, &sums_[done * Session::tile_sums]);
            }
            size_.took(count, each, launch.seconds());
            done += count;
            if (done < jobs_.size()) report(taken, done, samples, false);
        }
        return done;
    }

    void report(std::uint32_t taken, std::size_t jobs, std::uint32_t samples, bool round_ended) {
        if (!plan_.progress) return;
        const auto pixels = static_cast<double>(outcome_.film.pixels());
        const double part = round_ended ? 0 : static_cast<double>(jobs) / jobs_.size() * samples;
        plan_.progress(
            {pixels * (taken + part), pixels * plan_.samples, outcome_.film, round_ended});
    }

    Session& session_;
    const RenderPlan& plan_;
    LaunchSize size_;
    std::vector<LobeTileJob> jobs_;
    std::vector<LobeBlockSum> sums_;  // Session::tile_sums a job
    RenderOutcome outcome_;
};

}  // namespace

RenderOutcome render(Session& session, const RenderPlan& plan) { return Work(session, plan).run(); }

double measure_pace(Session& session) {
    const Film film(session.width(), session.height());
    constexpr std::uint32_t most = 64;
    std::vector<LobeTileJob> jobs;
    const std::uint32_t step = std::max(1u, film.tiles() / std::min(most, session.max_tiles()));
    for (std::uint32_t t = 0; t < film.tiles() && jobs.size() < session.max_tiles(); t += step)
        jobs.push_back({t, 0});
    std::vector<LobeBlockSum> sums(jobs.size() * Session::tile_sums);
    const auto count = static_cast<std::uint32_t>(jobs.size());
    session.render_tiles(jobs.data(), 1, 1, sums.data());  // the first launch may compile
    const Stopwatch watch;
    session.render_tiles(jobs.data(), count, 1, sums.data());
    return watch.seconds() * film.tiles() / count;
}

}  // namespace lobe
