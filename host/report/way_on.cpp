// SPDX-License-Identifier: Apache-2.0
#include "report/way_on.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lobe {
namespace {

constexpr const char* goals[] = {"--spp", "--time", "--error"};

// The command without its goals: "--spp 4" as well as "--spp=4".
std::string without_goals(const std::vector<std::string>& command) {
    std::string text;
    for (std::size_t i = 0; i < command.size(); ++i) {
        const std::string& word = command[i];
        const bool goal = std::find(std::begin(goals), std::end(goals),
                                    word.substr(0, word.find('='))) != std::end(goals);
        if (goal && word.find('=') == std::string::npos) ++i;  // its value
        if (!goal) text += (text.empty() ? "" : " ") + shell_word(word);
    }
    return text;
}

}  // namespace

double round_below(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double digit : {5.0, 2.0, 1.0, 0.5})
        if (digit * power < value * (1 - 1e-9)) return digit * power;
    return 0.2 * power;
}

std::string percent_text(double part) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g %%", 100 * part);
    return text;
}

std::string seconds_text(double seconds) {
    char text[32];
    if (seconds < 0.95) return "1 s";
    if (seconds < 99.5)
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    else if (seconds < 5970)
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    else
        std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
    return text;
}

std::string shell_word(const std::string& word) {
    static const std::string plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,/:%@^";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string command_text(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
    return text;
}

std::optional<WayOn> way_on(double error, double seconds, const std::vector<std::string>& command) {
    if (!(error > 0 && seconds > 0) || !std::isfinite(error)) return {};
    const double next = round_below(error);
    const double ratio = std::pow(error / next, 2);
    char option[48];
    std::snprintf(option, sizeof option, " --error %.4g%%", 100 * next);
    return WayOn{next, seconds * ratio, seconds * (ratio - 1), without_goals(command) + option};
}

}  // namespace lobe
