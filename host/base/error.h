// SPDX-License-Identifier: Apache-2.0
// The one exception of lobe: what went wrong, where, and what to do about it.
#pragma once

#include <stdexcept>
#include <string>

namespace lobe {

// What the process returns to the shell.
enum class ExitCode {
    ok = 0,
    internal = 1,
    usage = 2,
    scene = 3,
    device = 4,
    output = 5,
    nonfinite = 6,
    checkpoint = 7,
    comparison = 8,
};

// `what` names the fault with the offending value, `where` is FILE:LINE:COL or a file or empty,
// `hint` is one sentence that tells the user what to type or change (or empty).
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, std::string what, std::string where = "", std::string hint = "");

    ExitCode code() const { return code_; }
    const std::string& where() const { return where_; }
    const std::string& hint() const { return hint_; }

    // "lobe: error: WHERE: WHAT" and, on a second line, "lobe: hint: HINT" where there is one.
    std::string message() const;

  private:
    ExitCode code_;
    std::string where_, hint_;
};

// The candidate nearest to `name` by edit distance, or "" if none is near enough to be meant.
template <typename Names>
std::string nearest_name(const std::string& name, const Names& candidates);

// Text with every byte that could play tricks on a terminal written as \n, \t or \xNN: control
// bytes, and bytes that are not UTF-8.
std::string printable(const std::string& text);

// Number of single-character edits (insert, delete, replace, swap neighbours) between a and b.
unsigned edit_distance(const std::string& a, const std::string& b);

template <typename Names>
std::string nearest_name(const std::string& name, const Names& candidates) {
    std::string best;
    unsigned best_distance = static_cast<unsigned>(name.size()) / 3 + 2;
    for (const auto& candidate : candidates) {
        const unsigned distance = edit_distance(name, candidate);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

}  // namespace lobe
