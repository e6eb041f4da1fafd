// SPDX-License-Identifier: Apache-2.0
// How far a long job is: a bar on a terminal, else a line every ten seconds; nothing with --quiet.
#pragma once

#include <string>

#include "base/timer.h"

namespace lobe {

struct ProgressState {
    std::string what;    // "render"
    std::string unit;    // of the work, for the rate: "samples"
    double done = 0;     // in units
    double total = 0;    // in units; 0 is unknown
    double seconds = 0;  // since the beginning
    std::string detail;  // e.g. the current error: "error 2.1 %"
};

// "render  42 %  1.3 Msamples/s  ETA 1:05  error 2.1 %", without the bar.
std::string progress_text(const ProgressState& state);

// The same behind a bar, at most `columns` wide; with terminal colours if `colour`.
std::string progress_bar(const ProgressState& state, unsigned columns, bool colour);

std::string duration_text(double seconds);                        // "0:07", "1:02:03"
std::string amount_text(double amount, const std::string& unit);  // "1.30 Msamples"
std::string bytes_text(double bytes);                             // "3.2 GiB"

class Progress {
  public:
    Progress(std::string what, std::string unit);
    ~Progress();  // takes the bar away
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Cheap to call often; shows something only when it is time to.
    void update(double done, double total, const std::string& detail = "");

  private:
    ProgressState state_;
    Stopwatch watch_;
    bool terminal_, colour_;
    double next_;  // when to show again, in seconds
};

}  // namespace lobe
