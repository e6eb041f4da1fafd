// SPDX-License-Identifier: Apache-2.0
// When a render has reached a stated error.
#pragma once

#include <limits>

#include "report/estimate.h"

namespace lobe {

// Watches a film grow until its relative standard error is below a target with 95 % confidence.
// Far from the target looks only scout: they predict the samples needed and end nothing. Near it
// each look decides, and is one more chance to be fooled by luck, so decision j is held to the
// level 0.05 / (j (j + 1)); these add up to 0.05. Decisions come when the last look's prediction
// says so, at most 15 % of the samples apart: an error that falls by half for twice the time would
// else be passed by far.
class ErrorTarget {
  public:
    // `relative` is above 0.
    explicit ErrorTarget(double relative) : relative_(relative) {}

    // Whether the film is good enough. Only looks at it (a pass over all pixels) when it is time.
    bool met(const Film& film);
    // The same, but decides whether it is time or not: for a film that has come to its end.
    bool met_at_last(const Film& film);

    double relative() const { return relative_; }
    bool reached() const { return reached_; }
    unsigned looks() const { return looks_; }
    // What the error was below, with the confidence, at the last look; infinity before any.
    double bound() const { return bound_; }
    // Samples a pixel that are expected to do, by the last look; 0 while unknown.
    double samples_needed() const { return needed_; }
    // The last look's error, as a text.
    const std::string& error() const { return error_; }

  private:
    void look(const Film& film);

    double relative_;
    bool reached_ = false, deciding_ = false;
    unsigned looks_ = 0, decisions_ = 0;
    double bound_ = std::numeric_limits<double>::infinity(), needed_ = 0;
    double next_look_ = LOBE_BLOCK;
    std::string error_;
};

}  // namespace lobe
