// SPDX-License-Identifier: Apache-2.0
// Tables for terminals: columns that line up, whatever their text.
#pragma once

#include <string>
#include <vector>

namespace lobe {

// A header line and rows. A column whose cells all begin as numbers do ("12", "-3 %", "< 1e-9") or
// say that there is none ("-", "nan", "unknown") stands to the right, every other to the left.
class TextTable {
  public:
    explicit TextTable(std::vector<std::string> head);

    // A row with fewer cells than the head is filled with empty ones; one with more is a fault of
    // the caller: throws Error (internal).
    void add(std::vector<std::string> row);

    // One line each, two spaces between columns, nothing after the last cell, "\n" at the end.
    std::string text() const;

  private:
    std::vector<std::vector<std::string>> rows_;  // the first is the head
};

// Terminal columns that a UTF-8 text takes: 0 for combining marks, 2 for East Asian wide
// characters, 1 for all else; a byte that is not UTF-8 counts as 1.
std::size_t text_width(const std::string& text);

// Whether a column of a table, of which the first row is the head, stands to the right.
bool stands_right(const std::vector<std::vector<std::string>>& rows, std::size_t column);

}  // namespace lobe
