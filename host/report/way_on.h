// SPDX-License-Identifier: Apache-2.0
// What a better picture would cost, and the command that makes it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lobe {

struct WayOn {
    double error;         // the next round figure below the error reached
    double seconds;       // of rendering in all, if the error falls with the square root of time
    double more_seconds;  // than were spent
    std::string command;
};

// From a relative standard error reached in so many seconds of rendering. The command is the one
// given, without its --spp, --time and --error, with the new --error. Nothing for an error of 0.
std::optional<WayOn> way_on(double error, double seconds, const std::vector<std::string>& command);

// The largest of 1, 2, 5 times a power of ten that is less.
double round_below(double value);

// "1 %", "0.5 %".
std::string percent_text(double part);

// "41 s", "7 min", "2.5 h".
std::string seconds_text(double seconds);

// A command as a shell takes it.
std::string command_text(const std::vector<std::string>& words);

// A word as a shell takes it for one.
std::string shell_word(const std::string& word);

}  // namespace lobe
