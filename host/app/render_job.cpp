// SPDX-License-Identifier: Apache-2.0
#include "app/render_job.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <future>

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/progress.h"
#include "base/signals.h"
#include "report/adaptive.h"
#include "report/error_target.h"
#include "report/heavy_tail.h"
#include "report/html/render_page.h"
#include "report/picture_facts.h"

namespace lobe {
namespace {

// How many samples there is time for. `pace` is a first guess of the seconds a sample of all pixels
// takes, before the render's own pace is known.
class TimeBudget {
  public:
    TimeBudget(double seconds, double pace) : seconds_(seconds), pace_(pace) {}

    // At least one at first: a picture, late, is better than none.
    std::uint32_t samples(const Film& film, std::uint32_t wanted) const {
        const double done = film.mean_samples();
        const double pace = done > 0 ? spent_.seconds() / done : pace_;
        const double room = (seconds_ - spent_.seconds()) / std::max(pace, 1e-9);
        if (room >= wanted) return wanted;
        const auto fits = static_cast<std::uint32_t>(std::max(room, 0.0)) / 2 * 2;
        return done > 0 || fits > 0 ? fits : std::min(wanted, 1u);
    }

    double part() const { return std::min(1.0, spent_.seconds() / seconds_); }

  private:
    double seconds_, pace_;
    Stopwatch spent_;
};

// Shows how far the render is. Where no target is watched the error is estimated now and then, when
// it pays: it costs a pass.
class RenderWatch {
  public:
    RenderWatch(const std::optional<ErrorTarget>& target, const std::optional<TimeBudget>& budget)
        : target_(target), budget_(budget) {}

    void operator()(const RenderProgress& progress) {
        if (progress.round_ended && !is_quiet() && since_error_.seconds() > pause_) {
            const Stopwatch watch;
            error_ = "error " + (target_ ? target_->error() : error_text(estimate(progress.film)));
            pause_ = std::max(1.0, 30 * watch.seconds());
            since_error_.restart();
        }
        const double pixels = static_cast<double>(progress.film.pixels());
        double total = progress.samples_total;
        if (target_)
            total = target_->samples_needed() > 0
                        ? std::min(total, pixels * target_->samples_needed())
                        : 0;
        if (budget_ && budget_->part() > 0) {
            const double at_end = progress.samples_done / budget_->part();
            total = total > 0 ? std::min(total, at_end) : at_end;
        }
        shown_.update(progress.samples_done, total, error_);
    }

  private:
    const std::optional<ErrorTarget>& target_;
    const std::optional<TimeBudget>& budget_;
    Progress shown_{"render", "samples"};
    Stopwatch since_error_;
    double pause_ = 1;  // seconds between estimates: they stay below a thirtieth of the time
    std::string error_;
};

void warn_of_tail(const RenderReport& report) {
    if (!report.tail || !report.tail->heavy()) return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "a few samples are so bright (tail index %.1f, below 2) that the error bars "
                  "cannot be trusted: the true error may be larger",
                  report.tail->alpha);
    warn(text, report.scene);
}

}  // namespace

// Renders a pilot and gives the rates that its errors ask for.
std::vector<float> RenderJob::adapt(const RenderGoals& goals, std::uint64_t seed,
                                    const RenderPlan& plan) {
    RenderPlan pilot;
    pilot.samples = pilot_samples(goals.error || goals.time ? 0 : goals.samples);
    pilot.watchdog = plan.watchdog;
    pilot.stop = plan.stop;
    session_->set_seed(pilot_seed(seed));
    const RenderOutcome outcome = lobe::render(*session_, pilot);
    session_->set_seed(seed);
    const std::vector<float> rates = tile_rates(outcome.film);
    report_.end.pilot_samples = pilot.samples;
    report_.end.pilot_seconds = outcome.seconds;
    report_.end.least_rate = *std::min_element(rates.begin(), rates.end());
    report_.end.most_rate = *std::max_element(rates.begin(), rates.end());
    return rates;
}

void RenderJob::render(Session& session, const RenderGoals& goals, std::uint64_t seed,
                       Watchdog& watchdog) {
    session_ = &session;
    RenderEnd& end = report_.end;
    end.error_target = goals.error;
    end.time_target = goals.time;
    RenderPlan plan;
    plan.samples = goals.samples;
    plan.watchdog = &watchdog;
    plan.stop = [] { return stop_signal() != 0; };
    session.set_seed(seed);
    rendering_.restart();
    if (goals.adaptive) plan.rates = adapt(goals, seed, plan);

    std::optional<ErrorTarget> target;
    if (goals.error) target.emplace(*goals.error);
    std::optional<TimeBudget> budget;
    if (goals.time) {
        const double pace = measure_pace(session);
        budget.emplace(std::max(*goals.time - total_.seconds(), 1e-3), pace);
    }
    plan.next_samples = [&](const Film& film, std::uint32_t wanted) {
        if (target && target->met(film)) {
            end.by = "error";
            return 0u;
        }
        const std::uint32_t fits = budget ? budget->samples(film, wanted) : wanted;
        if (fits < wanted) end.by = "time";
        return fits;
    };
    RenderWatch shown(target, budget);
    plan.progress = [&](const RenderProgress& p) {
        film_ = &p.film;
        shown(p);
    };
    const RenderOutcome outcome = lobe::render(session, plan);
    if (target) {
        if (!outcome.stopped && target->met_at_last(outcome.film)) end.by = "error";
        end.looks = target->looks();
        end.error_bound = target->bound();
    }
    take(outcome.film, rendering_.seconds(), outcome.stopped);
    report_.status = session.status();
    report_.statistics = session.statistics();
    warn_of_tail(report_);
}

void RenderJob::take(const Film& film, double seconds, bool stopped) {
    report_.seconds.compile = session_->compile_seconds();
    report_.seconds.upload = session_->upload_seconds();
    report_.seconds.render = seconds;
    report_.picture = estimate(film);
    report_.tail = error_tail(report_.picture);
    report_.hash = image_hash(report_.picture);
    report_.partial = stopped;
    if (stopped) report_.end.by = "signal";
    report_.width = session_->width();
    report_.height = session_->height();
    report_.device_bytes = session_->device_bytes();
}

// Side by side. The first of several failures is told; the other pictures are written.
void RenderJob::write_pictures() {
    const Stopwatch watch;
    std::vector<std::future<void>> all;
    for (const std::string& output : report_.outputs)
        all.push_back(std::async(std::launch::async, [this, output] {
            images_.write(output, image_format(output) == "png"
                                      ? display_picture(report_.picture, outputs_.exposure)
                                      : float_picture(report_.picture,
                                                      picture_facts(report_, packed_.frame)));
        }));
    for (std::future<void>& one : all) one.get();
    report_.seconds.write = watch.seconds();
}

void RenderJob::write() {
    write_pictures();
    report_.seconds.total = total_.seconds();
    if (!outputs_.html.empty())
        write_file(outputs_.html, render_page(report_, images_, outputs_.exposure));
    if (outputs_.common.json != "-" && !outputs_.common.quiet)
        std::fputs(to_text(report_).c_str(), stdout);
    if (!outputs_.common.json.empty())
        write_json(outputs_.common.json, to_json(report_).dump(2) + "\n");
}

void RenderJob::end_hung(double seconds) {
    show_live_line("");
    std::string hint = "nothing was complete, nothing is written";
    try {
        if (film_ && film_->samples() > 0) {
            take(*film_, rendering_.seconds(), true);
            write();
            hint = "the picture of the samples before it is written";
        }
    } catch (const std::exception& error) {
        hint = std::string("the picture so far cannot be written: ") + error.what();
    }
    for (const BrdfTable& model : packed_.models)
        if (model.own) hint += "; do the loops of " + model.file + " end for all directions?";
    const Error error(ExitCode::device,
                      "a launch did not end within " + std::to_string(std::lround(seconds)) +
                          " s: the render is ended",
                      report_.scene, hint);
    std::fflush(stdout);
    std::fprintf(stderr, "%s\n", error.message().c_str());
    _exit(static_cast<int>(error.code()));
}

}  // namespace lobe
