// SPDX-License-Identifier: Apache-2.0
#include "report/error_target.h"

#include <algorithm>
#include <cmath>

namespace lobe {
namespace {

constexpr double largest_step = 1.15;  // between looks near the target, in samples
constexpr double far_away = 1.3;       // samples needed to those there are, where looks only scout

}  // namespace

bool ErrorTarget::met(const Film& film) {
    if (reached_ || film.mean_samples() < next_look_) return reached_;
    if (deciding_) return met_at_last(film);
    look(film);
    return false;
}

bool ErrorTarget::met_at_last(const Film& film) {
    if (reached_) return true;
    ++decisions_;
    look(film);
    reached_ = bound_ <= relative_;
    return reached_;
}

void ErrorTarget::look(const Film& film) {
    const double samples = film.mean_samples();
    const Estimate seen = estimate(film);
    ++looks_;
    const double decision = std::max(decisions_, 1u);  // this one, or the first to come
    bound_ = relative_error_bound(seen, 1 - 0.05 / (decision * (decision + 1)));
    error_ = error_text(seen);
    // A picture that says nothing of its error, being black or masked, never gets better at it.
    needed_ = std::isfinite(bound_) ? samples * std::pow(bound_ / relative_, 2) : 0;
    deciding_ = deciding_ || (needed_ > 0 && needed_ < far_away * samples);
    // Far away the prediction is poor (Sobol's error falls faster than it supposes), so only half
    // of the way is gone, in the logarithm.
    const double scouting = std::sqrt(samples * needed_);
    const double step = samples * largest_step;
    next_look_ = needed_ == 0 ? step : deciding_ ? std::min(needed_, step) : scouting;
}

}  // namespace lobe
