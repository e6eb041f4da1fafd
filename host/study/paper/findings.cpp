// SPDX-License-Identifier: Apache-2.0
#include "study/paper/findings.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"

namespace lobe {
namespace {

template <typename Value>
std::vector<double> values_of(const PaperCell& cell, const Value& value) {
    std::vector<double> values;
    for (const PaperRun& run : cell.runs) values.push_back(value(run));
    return values;
}

// Logarithms of a quantity's ratio, seed by seed, times `power`.
template <typename Value>
std::vector<double> log_ratios(const PaperCell& a, const PaperCell& b, double power,
                               const Value& value) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.runs.size(), b.runs.size()); ++i)
        ratios.push_back(power * std::log(value(a.runs[i]) / value(b.runs[i])));
    return ratios;
}

double mse(const PaperRun& run) { return run.error.mse; }
double mse_trimmed(const PaperRun& run) { return run.error.mse_trimmed; }
double absolute(const PaperRun& run) { return run.absolute; }
double seconds(const PaperRun& run) { return run.seconds; }

FootingFindings against(const PaperExperiment& experiment, Footing footing, std::size_t sampler) {
    FootingFindings found{footing, sampler, {}};
    const PaperCell& rational = experiment.settings[0].cells[sampler];
    std::vector<PairedRatios> things;
    for (std::size_t model : {1, 2}) {
        const PaperCell& other = experiment.settings[setting_of(model, footing)].cells[sampler];
        found.against[model - 1] = {ratio_interval(log_ratios(rational, other, 0.5, mse)),
                                    ratio_interval(log_ratios(rational, other, 0.5, mse_trimmed)),
                                    ratio_interval(log_ratios(rational, other, 1, absolute)),
                                    ratio_interval(log_ratios(rational, other, 1, seconds)),
                                    {}};
        things.push_back({log_ratios(other, rational, 1, mse)});
    }
    const std::vector<Judgement> judgements = judge(things);
    for (std::size_t k = 0; k < 2; ++k) found.against[k].judgement = judgements[k];
    return found;
}

}  // namespace

RatioInterval ratio_interval(const std::vector<double>& log_ratios) {
    const double middle = mean(log_ratios);
    const auto count = static_cast<double>(log_ratios.size());
    const double half = log_ratios.size() < 2
                            ? std::nan("")
                            : student_quantile(0.975, count - 1) * standard_error(log_ratios);
    return {std::exp(middle), std::exp(middle - half), std::exp(middle + half)};
}

Holds FootingFindings::holds() const {
    const Verdict a = against[0].judgement.verdict, b = against[1].judgement.verdict;
    if (a == Verdict::refused || b == Verdict::refused) return Holds::undecided;
    if (a == Verdict::win && b == Verdict::win) return Holds::yes;
    const auto fails = [](Verdict v) { return v == Verdict::loss || v == Verdict::tie; };
    return fails(a) || fails(b) ? Holds::no : Holds::undecided;
}

CellFindings cell_findings(const PaperCell& cell) {
    CellFindings found;
    const std::vector<double> squares = values_of(cell, mse), times = values_of(cell, seconds);
    const double square = mean(squares);
    const double half = squares.size() < 2
                            ? std::nan("")
                            : student_quantile(0.975, static_cast<double>(squares.size()) - 1) *
                                  standard_error(squares);
    found.rmse = std::sqrt(square);
    found.rmse_lo = std::sqrt(std::max(square - half, 0.0));
    found.rmse_hi = std::sqrt(square + half);
    found.absolute = 255 * mean(values_of(cell, absolute));
    found.trimmed = std::sqrt(mean(values_of(cell, mse_trimmed)));
    found.worst_share =
        mean(values_of(cell, [](const PaperRun& run) { return run.error.trimmed_share; }));
    found.seconds = median(times);
    found.timing_noise = std::sqrt(sample_variance(times)) / mean(times);
    return found;
}

PaperFindings findings_of(const PaperExperiment& experiment) {
    PaperFindings found;
    for (const PaperSetting& setting : experiment.settings) {
        std::array<CellFindings, 3> cells;
        for (std::size_t k = 0; k < cells.size(); ++k) cells[k] = cell_findings(setting.cells[k]);
        found.cells.push_back(cells);
        found.cut.push_back(ratio_interval(
            log_ratios(setting.cells[cosine_sampler], setting.cells[best_sampler], 0.5,
                       [](const PaperRun& run) { return run.error.mse * run.seconds; })));
    }
    for (const Footing footing : footings)
        for (std::size_t k = 0; k < paper_samplers.size(); ++k)
            found.footings.push_back(against(experiment, footing, k));
    return found;
}

}  // namespace lobe
