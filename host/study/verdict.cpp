// SPDX-License-Identifier: Apache-2.0
#include "study/verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/rank_test.h"
#include "base/statistics.h"

namespace lobe {
namespace {

// Normal approximation: the seeds at which a mean `distance` away shows at the level of 5 % with a
// power of 80 %.
double seeds_for(double deviation, double distance) {
    static const double quantiles = normal_quantile(0.975) + normal_quantile(0.8);
    const double root = quantiles * deviation / distance;
    return std::max(2.0, std::ceil(root * root));
}

// How far a mean log ratio is from the nearer border; never less than half a per cent, for nothing
// decides between ratios that lie on the border itself.
double distance_to_border(double mean) {
    const double distance =
        std::min(std::fabs(mean - std::log(win_above)), std::fabs(mean - std::log(loss_below)));
    return std::max(distance, std::log(1.005));
}

std::string refusal_of(const PairedRatios& thing) {
    if (!thing.refusal.empty()) return thing.refusal;
    if (thing.log_ratios.size() < least_seeds)
        return "fewer than " + std::to_string(least_seeds) + " seeds";
    for (double ratio : thing.log_ratios)
        if (!std::isfinite(ratio)) return "an error is not above that of the reference";
    if (thing.timing_noise > most_timing_noise) {
        char text[128];
        std::snprintf(text, sizeof text,
                      "times vary by %.0f %%, more than %.0f %%: a busy machine, or "
                      "too short a --time",
                      100 * thing.timing_noise, 100 * most_timing_noise);
        return text;
    }
    return "";
}

// All but what depends on the family.
Judgement measure(const PairedRatios& thing) {
    Judgement j;
    j.seeds = thing.log_ratios.size();
    j.reason = refusal_of(thing);
    if (!j.reason.empty()) j.verdict = Verdict::refused;
    const bool finite = std::all_of(thing.log_ratios.begin(), thing.log_ratios.end(),
                                    [](double r) { return std::isfinite(r); });
    if (j.seeds < 2 || !finite) {
        j.ratio = j.lo = j.hi = j.lo_family = j.hi_family = std::nan("");  // unknown
        return j;
    }
    const MeanInterval interval = mean_interval(thing.log_ratios, 1 - verdict_level);
    j.ratio = std::exp(interval.mean);
    j.lo = std::exp(interval.lo);
    j.hi = std::exp(interval.hi);
    j.p = interval.p;
    j.deviation = interval.deviation;
    j.wilcoxon_p = signed_rank_p(thing.log_ratios);
    j.seeds_for_5_percent = seeds_for(j.deviation, std::log(1.05));
    return j;
}

Verdict verdict_of(const Judgement& j) {
    const bool differs = j.p_holm < verdict_level && j.wilcoxon_p < verdict_level;
    if (differs && j.lo_family > win_above) return Verdict::win;
    if (differs && j.hi_family < loss_below) return Verdict::loss;
    if (j.lo_family >= loss_below && j.hi_family <= win_above) return Verdict::tie;
    return Verdict::undecided;
}

}  // namespace

std::string to_text(Verdict verdict) {
    switch (verdict) {
        case Verdict::win:
            return "WIN";
        case Verdict::loss:
            return "LOSS";
        case Verdict::tie:
            return "TIE";
        case Verdict::undecided:
            return "UNDECIDED";
        case Verdict::refused:
            break;
    }
    return "REFUSED";
}

std::vector<Judgement> judge(const std::vector<PairedRatios>& things) {
    std::vector<Judgement> judgements;
    std::vector<double> p;
    for (const PairedRatios& thing : things) {
        judgements.push_back(measure(thing));
        p.push_back(judgements.back().p);
    }
    const std::vector<double> adjusted = holm(p), levels = holm_levels(p, verdict_level);
    for (std::size_t i = 0; i < things.size(); ++i) {
        Judgement& j = judgements[i];
        j.p_holm = adjusted[i];
        if (j.verdict == Verdict::refused) continue;
        const MeanInterval interval = mean_interval(things[i].log_ratios, 1 - levels[i]);
        j.lo_family = std::exp(interval.lo);
        j.hi_family = std::exp(interval.hi);
        j.verdict = verdict_of(j);
        if (j.verdict == Verdict::undecided)
            j.seeds_needed = seeds_for(j.deviation, distance_to_border(std::log(j.ratio)));
    }
    return judgements;
}

PairedRatios combined(const std::vector<PairedRatios>& things) {
    PairedRatios all;
    std::size_t seeds = things.empty() ? 0 : things.front().log_ratios.size();
    for (const PairedRatios& thing : things) {
        seeds = std::min(seeds, thing.log_ratios.size());
        all.timing_noise = std::max(all.timing_noise, thing.timing_noise);
        if (all.refusal.empty()) all.refusal = thing.refusal;
    }
    all.log_ratios.assign(seeds, 0.0);
    for (const PairedRatios& thing : things)
        for (std::size_t s = 0; s < seeds; ++s)
            all.log_ratios[s] += thing.log_ratios[s] / static_cast<double>(things.size());
    return all;
}

}  // namespace lobe
