// SPDX-License-Identifier: Apache-2.0
// Which of two ways to render is better: the verdict, from log ratios that are paired over seeds.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lobe {

// Ratios are of B's error (times its time) over A's: above one, A is the better.
constexpr double win_above = 1.02;  // less of a difference is none in practice
constexpr double loss_below = 0.98;
constexpr double verdict_level = 0.05;
constexpr double most_timing_noise = 0.15;  // coefficient of variation of a time, per sample
constexpr unsigned least_seeds = 6;  // below, Wilcoxon's p cannot pass the level: 2 / 2^5 = .0625

enum class Verdict { win, loss, tie, undecided, refused };  // of A

// "WIN", "LOSS", "TIE", "UNDECIDED", "REFUSED".
std::string to_text(Verdict verdict);

// What one thing compared gave.
struct PairedRatios {
    std::vector<double> log_ratios;  // a seed each; any that is not finite is a refusal
    double timing_noise = 0;   // coefficient of variation of the time, the worse arm's; 0: no time
    std::string refusal = "";  // why there is nothing to judge, if there is not
};

struct Judgement {
    std::size_t seeds = 0;
    double ratio = 1, lo = 1, hi = 1;     // exp of the mean log ratio, 95 %: Student's t
    double lo_family = 1, hi_family = 1;  // at the level that Holm leaves it: the verdict's
    double p = 1, p_holm = 1;             // by Student's t, that the ratio is one
    double wilcoxon_p = 1;                // the same by signed ranks
    double deviation = 0;                 // of one log ratio
    Verdict verdict = Verdict::undecided;
    std::string reason;  // of a refusal; else ""
    // While undecided: seeds that would decide, with a chance of 80 %, if the ratio is as measured.
    std::optional<double> seeds_needed;
    // Seeds that show a ratio of 1.05 to differ from one with a chance of 80 %.
    std::optional<double> seeds_for_5_percent;
};

// The verdicts on several things compared at once (scenes; or one), Holm-adjusted over them:
//   WIN   the interval lies above 1.02, and both p are below the level;
//   LOSS  the interval lies below .98, and both p are below the level;
//   TIE   the interval lies within [.98, 1.02];
//   REFUSED  times vary by more than 15 %, or there is a reason not to judge;
//   UNDECIDED  anything else.
// Equal things lose or win in fewer than 5 % of trials: their interval must not only miss one but
// lie 2 % away from it.
std::vector<Judgement> judge(const std::vector<PairedRatios>& things);

// The geometric mean over things measured with the same seeds: means of their log ratios seed by
// seed, judged as one. Refused where any of them is.
PairedRatios combined(const std::vector<PairedRatios>& things);

}  // namespace lobe
