// SPDX-License-Identifier: Apache-2.0
#include "study/paper/experiment.h"

#include <algorithm>
#include <cmath>

#include "base/luminance.h"
#include "base/progress.h"
#include "base/timer.h"

namespace lobe {

const std::array<PaperSampler, 3> paper_samplers = {{
    {"cosine",
     "independent numbers, cosine directions: what the paper probably had",
     {Integrator::Sampler::independent, Integrator::Strategy::both, Integrator::Heuristic::power,
      Integrator::Directions::cosine}},
    {"matched",
     "independent numbers, each model's own directions",
     {Integrator::Sampler::independent, Integrator::Strategy::both, Integrator::Heuristic::power,
      Integrator::Directions::matched}},
    {"best", "Owen-scrambled Sobol, each model's own directions: lobe's default", Integrator()},
}};

namespace {

struct Cell {
    std::unique_ptr<Arm> arm;
    std::size_t setting, sampler;
};

double mean_absolute(const Estimate& picture, const Reference& reference,
                     const std::vector<bool>& masked) {
    double sum = 0, count = 0;
    for (std::size_t p = 0; p < masked.size(); ++p) {
        if (masked[p]) continue;
        for (std::size_t c = 3 * p; c < 3 * p + 3; ++c)
            sum += std::abs(static_cast<double>(picture.rgb[c]) - reference.rgb[c]);
        count += 3;
    }
    return count > 0 ? sum / count : 0;
}

double mean_luminance(const Reference& reference, const std::vector<bool>& masked) {
    double sum = 0, count = 0;
    for (std::size_t p = 0; p < masked.size(); ++p) {
        if (masked[p]) continue;
        sum += luminance(&reference.rgb[3 * p]);
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

class Job {
  public:
    Job(const PaperBench& bench, const PaperPlan& plan, const std::function<bool()>& stop)
        : bench_(bench), plan_(plan), stop_(stop ? stop : [] { return false; }) {}

    PaperExperiment run(const std::vector<Wearer>& wearers,
                        const std::vector<ModelSetting>& settings) {
        all_.wearers = wearers;
        for (const ModelSetting& setting : settings) all_.settings.push_back({setting});
        all_.stopped = !open_arms() || !take_references() || !run_rounds();
        for (PaperSetting& setting : all_.settings)
            for (PaperCell& cell : setting.cells)
                cell.runs.resize(std::min(cell.runs.size(), all_.rounds));
        return std::move(all_);
    }

  private:
    bool open_arms() {
        Progress shown("compile", "kernels");
        const double total = 3.0 * static_cast<double>(all_.settings.size());
        for (std::size_t s = 0; s < all_.settings.size(); ++s) {
            const Scene scene =
                dressed(bench_.scene, all_.wearers, all_.settings[s].setting, bench_.models);
            for (std::size_t k = 0; k < paper_samplers.size(); ++k) {
                if (stop_()) return false;
                shown.update(static_cast<double>(cells_.size()), total);
                PackOptions options;
                options.models = bench_.models;
                options.integrator = paper_samplers[k].integrator;
                const std::string name =
                    all_.settings[s].setting.name() + ", " + paper_samplers[k].name;
                cells_.push_back({std::make_unique<Arm>(name, bench_.device, bench_.kernels, scene,
                                                        options, bench_.parse_seconds),
                                  s, k});
                // The next arm of this program takes it from the cache.
                cells_.back().arm->keep_program();
                all_.settings[s].cells[k].start_up = cells_.back().arm->start_up();
                if (k == 0) describe(all_.settings[s], cells_.back().arm->packed());
            }
        }
        return true;
    }

    static void describe(PaperSetting& setting, const PackedScene& packed) {
        setting.features = packed.features;
        for (const BrdfTable& model : packed.models) setting.models.push_back(model.name);
    }

    bool take_references() {
        const Stopwatch watch;
        for (const Cell& cell : cells_) {
            if (cell.sampler != best_sampler) continue;
            std::optional<Reference> reference =
                reference_of(bench_.device, bench_.kernels, *cell.arm, plan_.reference_samples,
                             bench_.images, stop_);
            if (!reference) return false;
            all_.settings[cell.setting].reference = std::move(*reference);
        }
        all_.reference_seconds = watch.seconds();
        const Reference& first = all_.settings.front().reference;
        all_.width = first.width;
        all_.height = first.height;
        masked_ = first.masked;
        for (const PaperSetting& setting : all_.settings)
            for (std::size_t p = 0; p < masked_.size(); ++p)
                if (setting.reference.masked[p]) masked_[p] = true;
        all_.masked = static_cast<std::size_t>(std::count(masked_.begin(), masked_.end(), true));
        for (PaperSetting& setting : all_.settings) {
            setting.mean = mean_luminance(setting.reference, masked_);
            setting.variance = reference_variance(setting.reference, masked_);
        }
        return true;
    }

    bool run_rounds() {
        const Stopwatch watch;
        for (const Cell& cell : cells_)
            if (stop_() || cell.arm->run(plan_.first_seed, 1, stop_).stopped) return false;
        Progress shown("runs", "runs");
        for (std::uint32_t round = 0; round < plan_.runs; ++round) {
            for (std::size_t i = 0; i < cells_.size(); ++i) {
                shown.update(static_cast<double>(round * cells_.size() + i),
                             static_cast<double>(plan_.runs * cells_.size()));
                if (stop_() || !run_cell(cells_[round % 2 ? cells_.size() - 1 - i : i], round))
                    return false;
            }
            ++all_.rounds;
            all_.run_seconds = watch.seconds();
        }
        return true;
    }

    bool run_cell(const Cell& cell, std::uint32_t round) {
        const std::uint64_t seed = (plan_.first_seed + round) & ~reference_seed_bit;
        const ArmRun run = cell.arm->run(seed, plan_.samples, stop_);
        if (run.stopped) return false;
        PaperSetting& setting = all_.settings[cell.setting];
        PaperCell& results = setting.cells[cell.sampler];
        results.runs.push_back({seed, run.seconds,
                                picture_error(run.picture, setting.reference, masked_),
                                mean_absolute(run.picture, setting.reference, masked_)});
        for (std::size_t p = 0; p < masked_.size(); ++p)
            all_.stray += run.picture.sees_light[p] && !masked_[p];
        if (plan_.keep_pictures && round == 0) results.picture = run.picture.rgb;
        return true;
    }

    const PaperBench& bench_;
    const PaperPlan& plan_;
    const std::function<bool()> stop_;
    PaperExperiment all_;
    std::vector<Cell> cells_;
    std::vector<bool> masked_;
};

}  // namespace

PaperExperiment run_paper(const PaperBench& bench, const PaperPlan& plan,
                          const std::vector<Wearer>& wearers,
                          const std::vector<ModelSetting>& settings,
                          const std::function<bool()>& stop) {
    return Job(bench, plan, stop).run(wearers, settings);
}

}  // namespace lobe
