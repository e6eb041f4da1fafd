// SPDX-License-Identifier: Apache-2.0
#include "report/error_target.h"

#include <algorithm>
#include <cmath>

namespace lobe {
namespace {

constexpr double largest_step = 1.15;  // between looks near the target, in samples

// Where to look next, having `samples` of `needed`. Far away the prediction is poor (Sobol's error
// falls faster than it supposes), so only half of the way is gone, in the logarithm.
double next_look(double samples, double needed) {
    return std::max(std::sqrt(samples * needed), std::min(needed, samples * largest_step));
}

}  // namespace

bool ErrorTarget::met(const Film& film) {
    const double samples = film.mean_samples();
    return samples >= std::max<double>(LOBE_BLOCK, next_look_) && met_at_last(film);
}

bool ErrorTarget::met_at_last(const Film& film) {
    if (reached_) return true;
    const double samples = film.mean_samples();
    const Estimate look = estimate(film);
    ++looks_;
    const double level = 0.05 / (looks_ * (looks_ + 1.0));
    bound_ = relative_error_bound(look, 1 - level);
    error_ = error_text(look);
    reached_ = bound_ <= relative_;
    // A picture that says nothing of its error, being black or masked, never gets better at it.
    needed_ = std::isfinite(bound_) ? samples * std::pow(bound_ / relative_, 2) : 0;
    next_look_ = needed_ > 0 ? next_look(samples, needed_) : samples * largest_step;
    return reached_;
}

}  // namespace lobe
