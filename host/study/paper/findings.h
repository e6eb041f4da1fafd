// SPDX-License-Identifier: Apache-2.0
// What the runs of the paper's experiment say: means, ratios with intervals, and whether the
// rational model has the least error.
#pragma once

#include "study/paper/experiment.h"

namespace lobe {

// What becomes of a claim.
enum class Holds { yes, no, only_if, undecided };

// The paper's own row.
struct PaperRow {
    std::array<double, 3> seconds{297.3, 297.5, 299.2};
    std::array<double, 3> error{1.4937, 3.5009, 1.7680};
    double to_phong = 0.4267, to_modified = 0.8448;
};

// A geometric mean over seeds of a ratio, with its 95 % interval (NaN below two runs).
struct RatioInterval {
    double ratio = 1, lo = 1, hi = 1;
};
RatioInterval ratio_interval(const std::vector<double>& log_ratios);

// One cell's runs.
struct CellFindings {
    double seconds = 0;               // median
    double timing_noise = 0;          // coefficient of variation of the times
    double rmse = 0;                  // relative: root of the mean over runs of PictureError::mse
    double rmse_lo = 0, rmse_hi = 0;  // 95 %, over runs
    double absolute = 0;              // 255 x mean absolute error
    double trimmed = 0;               // rmse without the 0.1 % worst pixels of each run
    double worst_share = 0;           // of the squared error, in those pixels; mean over runs
};
CellFindings cell_findings(const PaperCell& cell);

// The rational model against another one, paired over seeds: its error over the other's.
struct AgainstRational {
    RatioInterval rmse, trimmed, absolute, time;
    Judgement judgement;  // of the squared errors: WIN is the rational model's
};

// On one footing and with one sampler; against Phong and modified Phong, Holm-adjusted over both.
struct FootingFindings {
    Footing footing;
    std::size_t sampler;
    std::array<AgainstRational, 2> against;
    // Whether the rational model has the lower error: it wins against both, or loses against one
    // or is no better; never only_if.
    Holds holds() const;
};

// By how much a sampler's error is the greater at equal time, if error falls with the root of time:
// root of the ratio of squared errors times time, over the best sampler's.
using NoiseCut = RatioInterval;

struct PaperFindings {
    std::vector<std::array<CellFindings, 3>> cells;  // settings x samplers
    std::vector<FootingFindings> footings;           // footings x samplers, samplers together
    std::vector<NoiseCut> cut;                       // a setting each: cosine over best
};
PaperFindings findings_of(const PaperExperiment& experiment);

}  // namespace lobe
