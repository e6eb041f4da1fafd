// SPDX-License-Identifier: Apache-2.0
#include "report/statistics_report.h"

#include <cstdio>

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

double percent(std::uint64_t part, std::uint64_t all) {
    return 100 * static_cast<double>(part) / static_cast<double>(all);
}

Json depths_json(const RenderStatistics& s) {
    Json depths = Json::object();
    for (unsigned bin = 0; bin < LOBE_DEPTH_BINS; ++bin)
        depths[RenderStatistics::depth_name(bin)] = s.paths_of_depth(bin);
    return depths;
}

}  // namespace

Json to_json(const RenderStatistics& s) {
    return {{"paths", s.paths()},
            {"mean_scattering_events", s.mean_depth()},
            {"paths_by_scattering_events", depths_json(s)},
            {"paths_by_end",
             {{"escaped", s[LOBE_STATISTIC_ESCAPED]},
              {"absorbed", s[LOBE_STATISTIC_LOST]},
              {"roulette", s[LOBE_STATISTIC_ROULETTE]},
              {"max_depth", s[LOBE_STATISTIC_TRUNCATED]}}},
            {"truncated_throughput", s.truncated_throughput()},
            {"directions", s[LOBE_STATISTIC_DIRECTIONS]},
            {"light_samples",
             {{"sent_for", s.light_samples()},
              {"reached", s[LOBE_STATISTIC_LIGHT_REACHED]},
              {"occluded", s[LOBE_STATISTIC_LIGHT_OCCLUDED]},
              {"useless", s[LOBE_STATISTIC_LIGHT_USELESS]}}}};
}

std::string to_text(const RenderStatistics& s) {
    if (s.paths() == 0) return "";
    char line[256];
    const std::uint64_t all = s.paths();
    std::snprintf(line, sizeof line,
                  "paths    %.2f scattering events on average; ended by escape %.0f %%, "
                  "absorption %.0f %%, roulette %.0f %%, largest depth %.0f %%\n",
                  s.mean_depth(), percent(s[LOBE_STATISTIC_ESCAPED], all),
                  percent(s[LOBE_STATISTIC_LOST], all), percent(s[LOBE_STATISTIC_ROULETTE], all),
                  percent(s[LOBE_STATISTIC_TRUNCATED], all));
    std::string text = line;
    const std::uint64_t sent = s.light_samples();
    if (sent == 0) return text;
    std::snprintf(line, sizeof line,
                  "lights   of the light samples %.0f %% reach, %.0f %% are occluded, %.0f %% "
                  "useless\n",
                  percent(s[LOBE_STATISTIC_LIGHT_REACHED], sent),
                  percent(s[LOBE_STATISTIC_LIGHT_OCCLUDED], sent),
                  percent(s[LOBE_STATISTIC_LIGHT_USELESS], sent));
    return text + line;
}

}  // namespace lobe
