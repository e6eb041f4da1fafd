// SPDX-License-Identifier: Apache-2.0
#include "report/sparkline.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

namespace lobe {
namespace {

const std::vector<std::string> blocks = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
const std::vector<std::string> ascii = {"_", ".", "-", "=", "*", "#"};

}  // namespace

std::string sparkline(const std::vector<double>& values, SparkScale scale, SparkSet set) {
    const bool plain = set == SparkSet::ascii || (set == SparkSet::automatic && !locale_is_utf8());
    const std::vector<std::string>& bars = plain ? ascii : blocks;
    std::vector<double> heights = values;
    if (scale == SparkScale::logarithmic)
        for (double& h : heights) h = h > 0 ? std::log(h) : NAN;
    double low = INFINITY, high = -INFINITY;
    for (const double h : heights) {
        if (!std::isfinite(h)) continue;
        low = std::min(low, h);
        high = std::max(high, h);
    }
    const auto steps = static_cast<double>(bars.size());
    std::string line;
    for (const double h : heights) {
        if (!std::isfinite(h)) {
            line += ' ';
            continue;
        }
        // Halves, because high - low may overflow.
        const double place = high > low ? (0.5 * h - 0.5 * low) / (0.5 * high - 0.5 * low) : 0.5;
        line += bars[static_cast<std::size_t>(std::min(steps - 1, std::floor(place * steps)))];
    }
    return line;
}

bool locale_is_utf8() {
    for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
        const char* value = std::getenv(name);
        if (!value || !*value) continue;
        std::string text;
        for (const char* c = value; *c; ++c)
            if (std::isalnum(static_cast<unsigned char>(*c)))
                text += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
        return text.find("utf8") != std::string::npos;
    }
    return false;
}

}  // namespace lobe
