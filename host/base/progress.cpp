// SPDX-License-Identifier: Apache-2.0
#include "base/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/log.h"

namespace lobe {

namespace {

constexpr double bar_interval = 0.1, line_interval = 10;  // seconds

std::string with_unit(const char* format, double value, const char* unit) {
    char text[64];
    std::snprintf(text, sizeof text, format, value, unit);
    return text;
}

bool is_set(const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
}

bool is_terminal() {
    const char* kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) && kind && *kind && std::string(kind) != "dumb";
}

unsigned terminal_columns() {
    struct winsize size = {};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col ? size.ws_col : 80;
}

double fraction(const ProgressState& state) {
    return state.total > 0 ? std::clamp(state.done / state.total, 0.0, 1.0) : 0;
}

}  // namespace

std::string duration_text(double seconds) {
    if (!(seconds >= 0 && seconds < 3.6e9)) return "?";
    const long long whole = std::llround(seconds);
    char text[64];
    if (whole < 3600)
        std::snprintf(text, sizeof text, "%lld:%02lld", whole / 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                      whole % 60);
    return text;
}

std::string amount_text(double amount, const std::string& unit) {
    static const char* const prefixes[] = {"", "k", "M", "G", "T"};
    unsigned power = 0;
    while (amount >= 999.5 && power < 4) {
        amount /= 1000;
        ++power;
    }
    const char* format = amount >= 99.95 ? "%.0f %s" : amount >= 9.995 ? "%.1f %s" : "%.2f %s";
    return with_unit(format, amount, prefixes[power]) + unit;
}

std::string bytes_text(double bytes) {
    static const char* const units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
    unsigned power = 0;
    while (bytes >= 1023.95 && power < 4) {
        bytes /= 1024;
        ++power;
    }
    return with_unit(power ? "%.1f %s" : "%.0f %s", bytes, units[power]);
}

std::string progress_text(const ProgressState& state) {
    std::string text = state.what;
    if (state.total > 0) text += with_unit("  %3.0f %%%s", std::floor(100 * fraction(state)), "");
    if (state.done > 0 && state.seconds > 0) {
        text += "  " + amount_text(state.done / state.seconds, state.unit) + "/s";
        if (state.total > 0)
            text += "  ETA " +
                    duration_text(state.seconds * std::max(0.0, state.total / state.done - 1));
    }
    if (state.total <= 0) text += "  " + duration_text(state.seconds);
    if (!state.detail.empty()) text += "  " + state.detail;
    return text;
}

std::string progress_bar(const ProgressState& state, unsigned columns, bool colour) {
    std::string text = progress_text(state);
    if (text.size() > columns) text.resize(columns);
    const std::size_t room = columns - text.size();
    if (state.total <= 0 || room < 13) return text;
    const std::size_t width = std::min<std::size_t>(room - 3, 30);
    const auto full = static_cast<std::size_t>(fraction(state) * static_cast<double>(width));
    const std::string done(full, '#'), rest(width - full, '.');
    return "[" + (colour ? "\x1b[32m" + done + "\x1b[0m" : done) + rest + "] " + text;
}

Progress::Progress(std::string what, std::string unit)
    : terminal_(is_terminal()),
      colour_(terminal_ && !is_set("NO_COLOR")),
      next_(terminal_ ? bar_interval : line_interval) {
    state_.what = std::move(what);
    state_.unit = std::move(unit);
}

Progress::~Progress() {
    if (terminal_) show_live_line("");
}

void Progress::update(double done, double total, const std::string& detail) {
    state_.seconds = watch_.seconds();
    if (is_quiet() || state_.seconds < next_) return;
    state_.done = done;
    state_.total = total;
    state_.detail = detail;
    next_ = state_.seconds + (terminal_ ? bar_interval : line_interval);
    if (terminal_)
        show_live_line(progress_bar(state_, terminal_columns() - 1, colour_));
    else
        note(progress_text(state_));
}

}  // namespace lobe
