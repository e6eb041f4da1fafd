// SPDX-License-Identifier: Apache-2.0
#include "cl/build_log.h"

#include <regex>
#include <sstream>

namespace lobe {

namespace {

// FILE:LINE:COL of the file that a person can edit. If the text has no marker for `file`, the line
// is one of the text itself.
std::string original_place(const std::string& text, const std::string& file, unsigned line,
                           const std::string& column) {
    static const std::regex marker("#line ([0-9]+) \"(.*)\"");
    std::istringstream lines(text);
    std::string marked_file;
    unsigned long marked_line = 0, number = 0, marker_at = 0;
    for (std::string content; std::getline(lines, content);) {
        ++number;
        std::smatch match;
        if (content.compare(0, 6, "#line ") != 0 || !std::regex_match(content, match, marker))
            continue;
        if (match.str(2) == file) return file + ":" + std::to_string(line) + ":" + column;
        if (number >= line) continue;
        marked_file = match.str(2);
        marked_line = std::stoul(match.str(1));
        marker_at = number;
    }
    if (marked_file.empty()) return file + ":" + std::to_string(line) + ":" + column;
    return marked_file + ":" + std::to_string(marked_line + line - marker_at - 1) + ":" + column;
}

}  // namespace

// PoCL writes `error: core/real.h:5:40: text`, Clang `core/real.h:5:40: error: text`.
BuildFault first_fault(const std::string& log, const std::string& text) {
    static const std::regex located("(.+?):([0-9]{1,9}):([0-9]+): *(.*)");
    static const std::regex marker("(fatal )?error: *");
    std::istringstream lines(log);
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        std::smatch error, place;
        if (!std::regex_search(line, error, marker)) continue;
        const std::string rest = error.prefix().str() + error.suffix().str();
        if (std::regex_match(rest, place, located)) {
            const auto number = static_cast<unsigned>(std::stoul(place.str(2)));
            return {original_place(text, place.str(1), number, place.str(3)), place.str(4)};
        }
        if (first.empty()) first = rest;
    }
    return {"", first};
}

}  // namespace lobe
