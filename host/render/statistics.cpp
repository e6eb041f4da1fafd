// SPDX-License-Identifier: Apache-2.0
#include "render/statistics.h"

namespace lobe {

void RenderStatistics::add(const std::vector<std::uint32_t>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) counters_[i % LOBE_STATISTIC_COUNT] += rows[i];
}

std::uint64_t RenderStatistics::paths() const {
    return counters_[LOBE_STATISTIC_ESCAPED] + counters_[LOBE_STATISTIC_LOST] +
           counters_[LOBE_STATISTIC_ROULETTE] + counters_[LOBE_STATISTIC_TRUNCATED];
}

std::uint64_t RenderStatistics::paths_of_depth(unsigned bin) const {
    return counters_[LOBE_STATISTIC_DEPTHS + bin];
}

const char* RenderStatistics::depth_name(unsigned bin) {
    static const char* const names[LOBE_DEPTH_BINS] = {"0", "1",   "2",    "3",
                                                       "4", "5-8", "9-16", "17+"};
    return names[bin];
}

std::uint64_t RenderStatistics::light_samples() const {
    return counters_[LOBE_STATISTIC_LIGHT_REACHED] + counters_[LOBE_STATISTIC_LIGHT_OCCLUDED] +
           counters_[LOBE_STATISTIC_LIGHT_USELESS];
}

// Every direction that was drawn is a scattering event, but for those that ended their path.
double RenderStatistics::mean_depth() const {
    const std::uint64_t events = counters_[LOBE_STATISTIC_DIRECTIONS] -
                                 counters_[LOBE_STATISTIC_LOST] -
                                 counters_[LOBE_STATISTIC_ROULETTE];
    return paths() ? static_cast<double>(events) / static_cast<double>(paths()) : 0;
}

double RenderStatistics::truncated_throughput() const {
    const auto sum = static_cast<double>(counters_[LOBE_STATISTIC_TRUNCATED_THROUGHPUT]);
    return paths() ? sum / LOBE_TRUNCATED_UNIT / static_cast<double>(paths()) : 0;
}

}  // namespace lobe
