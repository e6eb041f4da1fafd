// SPDX-License-Identifier: Apache-2.0
// The pictures of one level, added up pixel by pixel.
#pragma once

#include "study/convergence.h"

namespace lobe {

class LevelSums {
  public:
    LevelSums(std::uint32_t samples, std::size_t pixels);

    void add(const Estimate& picture);

    std::uint32_t samples() const { return samples_; }
    double count() const { return count_; }
    // Luminance: mean over the pictures, and the variance of one of them.
    double mean(std::size_t pixel) const { return sums_[pixel] / count_; }
    double variance(std::size_t pixel) const;

  private:
    std::uint32_t samples_;
    double count_ = 0;
    std::vector<double> sums_, squares_;
    std::vector<float> origin_;  // the first picture: squares are of differences from it
};

// What one render is worth. `masked` has an entry a pixel.
ConvergenceRun measure_run(const ArmRun& run, const Reference& reference,
                           const std::vector<bool>& masked);

// What all renders of a level are worth together, all but the band.
ConvergenceLevel measure_level(const LevelSums& sums, const std::vector<ConvergenceRun>& runs,
                               unsigned level, const Reference& reference,
                               const std::vector<bool>& masked);

// The tail of the errors of the first level's pictures (their luminances one after the other), each
// error over the standard deviation that the other levels see in its pixel. Nothing where those
// have fewer than 30 degrees of freedom.
std::optional<TailIndex> error_tail(const std::vector<std::vector<float>>& pictures,
                                    const std::vector<LevelSums>& sums, const Reference& reference,
                                    const std::vector<bool>& masked);

}  // namespace lobe
