// SPDX-License-Identifier: Apache-2.0
#include "study/convergence.h"

#include <algorithm>
#include <cmath>

#include "base/luminance.h"
#include "base/progress.h"
#include "study/convergence_fit.h"
#include "study/convergence_level.h"

namespace lobe {
namespace {

constexpr unsigned least_seeds = 3;

ConvergenceReport begin(const Arm& arm, const Reference& reference, const ConvergencePlan& plan) {
    ConvergenceReport report;
    report.path = arm.name();
    report.content_hash = arm.content_hash();
    report.plan = plan;
    report.width = arm.width();
    report.height = arm.height();
    const PackedScene& packed = arm.packed();
    report.integrator = packed.integrator;
    report.features = packed.features;
    for (const BrdfTable& model : packed.models) report.models.push_back(model.name);
    report.triangles = packed.triangles.size();
    report.spheres = packed.spheres.size();
    report.lights = packed.lights.lights.size();
    report.start_up = arm.start_up();
    report.reference = reference;
    return report;
}

std::vector<bool> mask_of(const Reference& reference, bool wanted) {
    return wanted ? reference.masked : std::vector<bool>(reference.masked.size());
}

void describe_reference(ConvergenceReport& report, const std::vector<bool>& masked) {
    double light = 0, variance = 0, pixels = 0;
    for (std::size_t p = 0; p < masked.size(); ++p) {
        if (masked[p]) {
            ++report.masked;
            continue;
        }
        const double error = report.reference.luminance_error[p];
        light += luminance(&report.reference.rgb[3 * p]);
        variance += error * error;
        ++pixels;
    }
    report.reference_mean = light / pixels;
    report.reference_variance = variance / pixels;
    report.relmse_epsilon = 1e-2 * report.reference_mean * report.reference_mean;
}

// The renders, seed by seed: a seed counts when all of its levels are done.
class Measuring {
  public:
    Measuring(Arm& arm, ConvergenceReport& report, const std::vector<bool>& masked,
              const std::function<bool()>& stop)
        : arm_(arm), report_(report), masked_(masked), stop_(stop) {
        for (unsigned k = 0; k < report.plan.levels; ++k)
            sums_.emplace_back(report.plan.samples(k), masked.size());
    }

    void run() {
        arm_.run(report_.plan.first_seed, report_.plan.first, [&] { return asked(); });  // warm up
        status_ = arm_.status();
        for (unsigned seed = 0; seed < report_.plan.seeds && !report_.stopped; ++seed)
            render_seed(seed);
    }

    const std::vector<LevelSums>& sums() const { return sums_; }
    const std::vector<std::vector<float>>& first_pictures() const { return first_pictures_; }

  private:
    bool asked() {
        shown_.update(done_, report_.plan.all_samples() * static_cast<double>(masked_.size()));
        return stop_ && stop_();
    }

    void render_seed(unsigned seed) {
        const ConvergencePlan& plan = report_.plan;
        std::vector<Estimate> pictures(plan.levels);
        std::vector<ConvergenceRun> runs(plan.levels);
        for (unsigned i = 0; i < plan.levels; ++i) {
            const unsigned k = seed % 2 ? plan.levels - 1 - i : i;
            ArmRun run =
                arm_.run(plan.first_seed + 64 * seed + k, plan.samples(k), [&] { return asked(); });
            report_.stopped = run.stopped;
            if (run.stopped) return;
            runs[k] = measure_run(run, report_.reference, masked_);
            runs[k].level = k;
            count_odd_samples(runs[k]);
            pictures[k] = std::move(run.picture);
            done_ += plan.samples(k) * static_cast<double>(masked_.size());
        }
        for (unsigned k = 0; k < plan.levels; ++k) sums_[k].add(pictures[k]);
        std::vector<float> light;
        for (std::size_t p = 0; p < masked_.size(); ++p)
            light.push_back(static_cast<float>(luminance(&pictures[0].rgb[3 * p])));
        first_pictures_.push_back(std::move(light));
        report_.runs.insert(report_.runs.end(), runs.begin(), runs.end());
        ++report_.seeds;
    }

    void count_odd_samples(ConvergenceRun& run) {
        const RenderStatus now = arm_.status();
        run.nonfinite = now.nonfinite() - status_.nonfinite();
        run.negative = now.negative() - status_.negative();
        status_ = now;
    }

    Arm& arm_;
    ConvergenceReport& report_;
    const std::vector<bool>& masked_;
    const std::function<bool()>& stop_;
    Progress shown_{"converge", "samples"};
    double done_ = 0;
    RenderStatus status_;
    std::vector<LevelSums> sums_;
    std::vector<std::vector<float>> first_pictures_;
};

void add_warnings(ConvergenceReport& r) {
    std::uint64_t nonfinite = 0, negative = 0;
    for (const ConvergenceRun& run : r.runs) {
        nonfinite += run.nonfinite;
        negative += run.negative;
    }
    if (nonfinite)
        r.warnings.push_back(std::to_string(nonfinite) +
                             " samples were not finite and count as black");
    if (negative) r.warnings.push_back(std::to_string(negative) + " samples were negative");
    if (r.tail && r.tail->heavy())
        r.warnings.push_back(
            "the errors have a heavy tail: their variance may be infinite, and "
            "the intervals too narrow");
    const ConvergenceLevel& last = r.levels.back();
    if (last.seconds_deviation > 0.15 * last.seconds)
        r.warnings.push_back("the times vary by more than 15 %: figures made of them are rough");
    if (!(last.mse.value > 0))
        r.warnings.push_back(
            "the errors are no larger than the reference's own: give it more "
            "samples with --reference-spp");
}

}  // namespace

double ConvergencePlan::all_samples() const {
    return static_cast<double>(seeds) * first * ((std::uint64_t{1} << levels) - 1.0);
}

std::uint32_t ConvergencePlan::reference_samples() const {
    const double wanted = std::min(100.0 * samples(levels - 1), all_samples());
    return static_cast<std::uint32_t>(std::min(wanted, 0x1p30));
}

double relative_error(const ConvergenceReport& report, double mse) {
    return std::sqrt(mse) / report.reference_mean;
}

ConvergenceReport measure_convergence(Arm& arm, const Reference& reference,
                                      const ConvergencePlan& plan,
                                      const std::function<bool()>& stop) {
    ConvergenceReport report = begin(arm, reference, plan);
    const std::vector<bool> masked = mask_of(reference, plan.mask);
    describe_reference(report, masked);
    Measuring measuring(arm, report, masked, stop);
    measuring.run();
    if (report.seeds < least_seeds || report.masked == masked.size()) return report;
    for (unsigned k = 0; k < plan.levels; ++k)
        report.levels.push_back(
            measure_level(measuring.sums()[k], report.runs, k, reference, masked));
    report.tail = error_tail(measuring.first_pictures(), measuring.sums(), reference, masked);
    fit_levels(report, reference_floor_variance(reference, masked));
    add_warnings(report);
    return report;
}

}  // namespace lobe
