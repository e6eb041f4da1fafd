// SPDX-License-Identifier: Apache-2.0
#include "base/log.h"

#include <atomic>
#include <cstdio>
#include <mutex>

#include "base/error.h"

namespace lobe {

namespace {

std::atomic<bool> quiet{false};
std::mutex mutex;
std::string live_line;

const char* const clear_line = "\r\x1b[K";

void print_above_live_line(const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex);
    std::string out = live_line.empty() ? "" : clear_line;
    out += "lobe: " + text + "\n" + live_line;
    std::fputs(out.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace

void set_quiet(bool value) { quiet = value; }
bool is_quiet() { return quiet; }

void warn(const std::string& text, const std::string& where) {
    print_above_live_line("warning: " + (where.empty() ? "" : printable(where) + ": ") +
                          printable(text));
}

void note(const std::string& text) {
    if (!quiet) print_above_live_line(printable(text));
}

void show_live_line(const std::string& line) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (line.empty() && live_line.empty()) return;
    live_line = line;
    std::fputs((clear_line + line).c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace lobe
