// SPDX-License-Identifier: Apache-2.0
// What became of the paths of a render and of the light samples on their way: whole numbers, the
// same however the render was cut into launches and work-groups.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shared/statistics.h"

namespace lobe {

class RenderStatistics {
  public:
    // Adds rows of LOBE_STATISTIC_COUNT counters, one for each tile of a launch.
    void add(const std::vector<std::uint32_t>& rows);

    // Counter LOBE_STATISTIC_..., e.g. of the light samples that were occluded.
    std::uint64_t operator[](unsigned counter) const { return counters_[counter]; }

    // All paths, one a sample; and those of one bin of LOBE_STATISTIC_DEPTHS.
    std::uint64_t paths() const;
    std::uint64_t paths_of_depth(unsigned bin) const;
    // "0" ... "4", "5-8", "9-16", "17+" scattering events.
    static const char* depth_name(unsigned bin);

    std::uint64_t light_samples() const;

    // Scattering events of a path in the mean; 0 without paths.
    double mean_depth() const;
    // Luminance of the throughput that the largest depth cuts off, a path in the mean. What is
    // missing from the picture is this times the radiance that the surfaces there scatter.
    double truncated_throughput() const;

  private:
    std::array<std::uint64_t, LOBE_STATISTIC_COUNT> counters_{};
};

}  // namespace lobe
