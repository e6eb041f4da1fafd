// SPDX-License-Identifier: Apache-2.0
#include "study/comparison.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/luminance.h"
#include "base/progress.h"
#include "base/rank_test.h"
#include "base/statistics.h"

namespace lobe {
namespace {

// Arms whose times are not seen to differ by more than this have the same number of samples at
// equal time: the error times time makes up for it, and noise of the clock must not choose the
// samples.
constexpr double same_time = 1.1;

// Seconds of a run of so many samples: fixed + per_sample * samples.
struct RunCost {
    double fixed = 0, per_sample = 0;
    double seconds(double samples) const { return fixed + per_sample * samples; }
    double samples(double seconds) const { return (seconds - fixed) / per_sample; }
};

double median_seconds(const std::vector<ComparedRun>& runs) {
    std::vector<double> seconds;
    for (const ComparedRun& run : runs) seconds.push_back(run.seconds);
    return median(seconds);
}

// From the rows with the fewest and the most samples.
RunCost cost_of(const std::vector<ComparisonRow>& rows,
                std::vector<ComparedRun> ComparisonRow::*arm) {
    const auto fewer = [](const ComparisonRow& x, const ComparisonRow& y) {
        return x.samples_a < y.samples_a;
    };
    const auto [low, high] = std::minmax_element(rows.begin(), rows.end(), fewer);
    const double few = low->samples_a, many = high->samples_a;
    const double t_few = median_seconds((*low).*arm), t_many = median_seconds((*high).*arm);
    RunCost cost{0, t_many / many};
    if (many > few && t_many > t_few) {
        cost.per_sample = (t_many - t_few) / (many - few);
        cost.fixed = std::max(0.0, t_few - cost.per_sample * few);
    }
    return cost;
}

// Whether the times at the most samples, paired by seed, leave it open that the arms are alike.
bool alike(const std::vector<ComparisonRow>& rows) {
    const ComparisonRow& row = *std::max_element(
        rows.begin(), rows.end(),
        [](const ComparisonRow& x, const ComparisonRow& y) { return x.samples_a < y.samples_a; });
    std::vector<double> log_ratios;
    for (std::size_t s = 0; s < row.a.size(); ++s)
        log_ratios.push_back(std::log(row.b[s].seconds / row.a[s].seconds));
    const MeanInterval ratio = mean_interval(log_ratios, 0.999);
    return ratio.lo < std::log(same_time) && ratio.hi > -std::log(same_time);
}

double variation(const std::vector<ComparedRun>& runs) {
    std::vector<double> seconds;
    for (const ComparedRun& run : runs) seconds.push_back(run.seconds);
    return std::sqrt(sample_variance(seconds)) / mean(seconds);
}

double mean_luminance(const Reference& reference, const std::vector<bool>& masked) {
    std::vector<double> values;
    for (std::size_t p = 0; p < masked.size(); ++p)
        if (!masked[p]) values.push_back(luminance(&reference.rgb[3 * p]));
    return values.empty() ? 0 : mean(values);
}

// One scene's experiment while it runs.
class Experiment {
  public:
    Experiment(const MeasuredArm& a, const MeasuredArm& b, const ComparisonPlan& plan,
               const std::function<bool()>& stop)
        : a_(a), b_(b), plan_(plan), stop_(stop), masked_(a.reference.masked) {
        for (std::size_t p = 0; p < masked_.size(); ++p)
            if (b.reference.masked[p]) masked_[p] = true;
        const double pixels = static_cast<double>(masked_.size());
        double runs = 0;
        for (std::uint32_t samples : plan.samples) runs += 2.0 * samples;
        for (double time : plan.times) runs += 2 * time * plan.base_samples + warm_up_samples();
        total_ = pixels * (plan.seeds * runs + warm_up_samples());
    }

    const std::vector<bool>& masked() const { return masked_; }

    bool warm_up() {
        for (unsigned i = 0; i < plan_.warm_up; ++i)
            for (const MeasuredArm* arm : {&a_, &b_})
                if (!measure(*arm, plan_.first_seed, least_samples())) return false;
        return true;
    }

    // Arms in the order A B, B A, A B, ...: what drifts slowly touches both alike.
    bool run_row(ComparisonRow& row) {
        for (std::uint32_t s = 0; s < plan_.seeds; ++s) {
            if (row.equal_time && !reopen(s % 2 == 0)) return false;
            std::optional<ComparedRun> a, b;
            if (s % 2 == 0) a = measure(a_, seed_a(s), row.samples_a);
            b = measure(b_, seed_b(s), row.samples_b);
            if (s % 2 == 1) a = measure(a_, seed_a(s), row.samples_a);
            if (!a || !b) return false;
            row.a.push_back(*a);
            row.b.push_back(*b);
        }
        take_ratios(row);
        return true;
    }

    // Rows at equal samples have been run: they tell the cost of a sample.
    std::vector<ComparisonRow> plan_times(const std::vector<ComparisonRow>& rows) {
        const RunCost a = cost_of(rows, &ComparisonRow::a), b = cost_of(rows, &ComparisonRow::b);
        const bool same = alike(rows);
        const double pixels = static_cast<double>(masked_.size());
        std::vector<ComparisonRow> times;
        double left = 0;
        for (double multiple : plan_.times) {
            ComparisonRow row;
            row.equal_time = true;
            row.samples_a =
                even_samples(plan_.base_seconds > 0 ? a.samples(multiple * plan_.base_seconds)
                                                    : multiple * plan_.base_samples);
            row.aim_seconds =
                plan_.base_seconds > 0 ? multiple * plan_.base_seconds : a.seconds(row.samples_a);
            row.samples_b = same ? row.samples_a : even_samples(b.samples(row.aim_seconds));
            left += pixels * plan_.seeds *
                    (double{1} * row.samples_a + row.samples_b + warm_up_samples());
            times.push_back(row);
        }
        total_ = done_ + left;
        return times;
    }

  private:
    std::uint32_t least_samples() const {
        return *std::min_element(plan_.samples.begin(), plan_.samples.end());
    }
    double warm_up_samples() const { return 2.0 * plan_.warm_up * least_samples(); }
    std::uint64_t seed_a(std::uint32_t s) const { return plan_.first_seed + s; }
    std::uint64_t seed_b(std::uint32_t s) const {
        return seed_a(s) + (plan_.own_seeds ? std::uint64_t{1} << 62 : 0);
    }

    // Two sessions of one and the same program differ in speed for as long as they live, for where
    // their memory happens to lie: some 8 % were seen with PoCL. So the runs that times are
    // compared of have one each: what was a fault common to all seeds is noise between them,
    // which the interval over seeds measures. Both are closed first and opened in the order of the
    // runs: an allocator that gives the same places again gives them to both arms in turn.
    bool reopen(bool a_first) {
        const MeasuredArm &first = a_first ? a_ : b_, &second = a_first ? b_ : a_;
        for (Arm* arm : {&first.arm, &second.arm}) arm->close();
        for (Arm* arm : {&first.arm, &second.arm}) arm->reopen();
        return warm_up();
    }

    std::optional<ComparedRun> measure(const MeasuredArm& measured, std::uint64_t seed,
                                       std::uint32_t samples) {
        if (stop_ && stop_()) return {};
        const ArmRun run = measured.arm.run(seed, samples, stop_);
        if (run.stopped) return {};
        done_ += static_cast<double>(masked_.size()) * samples;
        shown_.update(done_, total_, measured.arm.name());
        return ComparedRun{seed, samples, run.seconds,
                           picture_error(run.picture, measured.reference, masked_)};
    }

    void take_ratios(ComparisonRow& row) {
        for (std::size_t s = 0; s < row.a.size(); ++s) {
            const ComparedRun &a = row.a[s], &b = row.b[s];
            const double times = row.equal_time ? std::log(b.seconds / a.seconds) : 0;
            row.ratios.log_ratios.push_back(std::log(b.error.mse) - std::log(a.error.mse) + times);
            row.trimmed_ratios.log_ratios.push_back(std::log(b.error.mse_trimmed) -
                                                    std::log(a.error.mse_trimmed) + times);
        }
        if (!row.equal_time) return;
        row.ratios.timing_noise = std::max(variation(row.a), variation(row.b));
        row.trimmed_ratios.timing_noise = row.ratios.timing_noise;
    }

    const MeasuredArm &a_, &b_;
    const ComparisonPlan& plan_;
    const std::function<bool()>& stop_;
    std::vector<bool> masked_;
    double done_ = 0, total_ = 0;  // samples, over all pixels
    Progress shown_{"compare", "samples"};
};

void check_sizes(const Arm& a, const Arm& b) {
    if (a.width() == b.width() && a.height() == b.height()) return;
    const auto size = [](const Arm& arm) {
        return std::to_string(arm.width()) + "x" + std::to_string(arm.height());
    };
    throw Error(ExitCode::usage, "the films differ: A has " + size(a) + " pixels, B " + size(b), "",
                "give both the same --resolution, e.g. --resolution " + size(a));
}

ComparedArm facts_of(const MeasuredArm& measured, const std::vector<bool>& masked) {
    ComparedArm facts;
    facts.name = measured.arm.name();
    facts.integrator = to_text(measured.arm.packed().integrator);
    facts.content_hash = measured.arm.content_hash();
    facts.start_up = measured.arm.start_up();
    facts.features = measured.arm.packed().features;
    for (const BrdfTable& model : measured.arm.packed().models) facts.models.push_back(model.name);
    facts.nonfinite = measured.arm.status().nonfinite();
    facts.reference_samples = measured.reference.samples;
    facts.reference_variance = reference_variance(measured.reference, masked);
    facts.reference_seconds = measured.reference.seconds;
    facts.reference_from_cache = measured.reference.from_cache;
    facts.mean = mean_luminance(measured.reference, masked);
    return facts;
}

}  // namespace

std::uint32_t even_samples(double wanted) {
    if (!(wanted > 2)) return 2;
    const double limited = std::min(wanted, 0x1p30);
    const double step = std::max(2.0, std::exp2(std::floor(std::log2(limited)) - 2));
    const double below = std::floor(limited / step) * step;
    return static_cast<std::uint32_t>(limited * limited < below * (below + step) ? below
                                                                                 : below + step);
}

std::optional<SceneComparison> run_comparison(const MeasuredArm& a, const MeasuredArm& b,
                                              const ComparisonPlan& plan,
                                              const std::function<bool()>& stop) {
    check_sizes(a.arm, b.arm);
    Experiment experiment(a, b, plan, stop);
    SceneComparison comparison;
    comparison.same_content = a.arm.content_hash() == b.arm.content_hash();
    comparison.width = a.arm.width();
    comparison.height = a.arm.height();
    const std::vector<bool>& masked = experiment.masked();
    comparison.masked = static_cast<std::size_t>(std::count(masked.begin(), masked.end(), true));
    if (!experiment.warm_up()) return {};
    for (std::uint32_t samples : plan.samples) {
        ComparisonRow row;
        row.samples_a = row.samples_b = samples;
        comparison.rows.push_back(row);
        if (!experiment.run_row(comparison.rows.back())) return {};
    }
    for (ComparisonRow& row : experiment.plan_times(comparison.rows)) {
        comparison.rows.push_back(row);
        if (!experiment.run_row(comparison.rows.back())) return {};
    }
    comparison.a = facts_of(a, masked);
    comparison.b = facts_of(b, masked);
    return comparison;
}

void judge_rows(std::vector<SceneComparison>& scenes) {
    if (scenes.empty()) return;
    for (std::size_t r = 0; r < scenes.front().rows.size(); ++r) {
        std::vector<PairedRatios> ratios, trimmed;
        for (const SceneComparison& scene : scenes) {
            ratios.push_back(scene.rows[r].ratios);
            trimmed.push_back(scene.rows[r].trimmed_ratios);
        }
        const std::vector<Judgement> all = judge(ratios), all_trimmed = judge(trimmed);
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            scenes[i].rows[r].judgement = all[i];
            scenes[i].rows[r].trimmed = all_trimmed[i];
        }
    }
}

}  // namespace lobe
