// SPDX-License-Identifier: Apache-2.0
#include "report/text_table.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "base/error.h"

namespace lobe {
namespace {

using Row = std::vector<std::string>;

// The character at text[at], and how many bytes it has; what is not UTF-8 is one byte.
struct Character {
    std::uint32_t code;
    std::size_t size;
};
Character character_at(const std::string& text, std::size_t at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t size = lead < 0xc2 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    if (size == 1 || lead > 0xf4 || at + size > text.size()) return {lead, 1};
    std::uint32_t code = lead & (0xffu >> (size + 1));
    for (std::size_t k = 1; k < size; ++k) {
        const auto next = static_cast<unsigned char>(text[at + k]);
        if ((next & 0xc0) != 0x80) return {lead, 1};
        code = code << 6 | (next & 0x3f);
    }
    return {code, size};
}

struct Range {
    std::uint32_t first, last;
};
constexpr Range combining[] = {{0x300, 0x36f},   {0x200b, 0x200f}, {0x20d0, 0x20ff},
                               {0x1ab0, 0x1aff}, {0x1dc0, 0x1dff}, {0xfe00, 0xfe0f},
                               {0xfe20, 0xfe2f}};
constexpr Range wide[] = {
    {0x1100, 0x115f}, {0x2e80, 0xa4cf}, {0xac00, 0xd7a3},   {0xf900, 0xfaff},   {0xfe30, 0xfe6f},
    {0xff00, 0xff60}, {0xffe0, 0xffe6}, {0x1f300, 0x1f64f}, {0x1f900, 0x1f9ff}, {0x20000, 0x3fffd}};

template <std::size_t n>
bool holds(const Range (&ranges)[n], std::uint32_t code) {
    return std::any_of(ranges, ranges + n,
                       [&](const Range& r) { return code >= r.first && code <= r.last; });
}

bool is_number(const std::string& cell) {
    static const char* const words[] = {"", "-", "nan", "inf", "unknown", "none"};
    for (const char* word : words)
        if (cell == word) return true;
    const std::size_t digit = cell.find_first_not_of("<>=~+-. ");
    return digit != std::string::npos && (std::isdigit(static_cast<unsigned char>(cell[digit])) ||
                                          cell.compare(digit, std::string::npos, "inf") == 0);
}

}  // namespace

bool stands_right(const std::vector<Row>& rows, std::size_t column) {
    bool any = false;
    for (std::size_t r = 1; r < rows.size(); ++r) {
        if (!is_number(rows[r][column])) return false;
        any = any || !rows[r][column].empty();
    }
    return any;
}

std::size_t text_width(const std::string& text) {
    std::size_t width = 0;
    for (std::size_t at = 0; at < text.size();) {
        const Character c = character_at(text, at);
        width += holds(combining, c.code) ? 0 : holds(wide, c.code) ? 2 : 1;
        at += c.size;
    }
    return width;
}

TextTable::TextTable(Row head) { rows_.push_back(std::move(head)); }

void TextTable::add(Row row) {
    if (row.size() > rows_[0].size())
        throw Error(ExitCode::internal, "a table's row has " + std::to_string(row.size()) +
                                            " cells for " + std::to_string(rows_[0].size()) +
                                            " columns");
    row.resize(rows_[0].size());
    rows_.push_back(std::move(row));
}

std::string TextTable::text() const {
    std::vector<std::string> lines(rows_.size());
    for (std::size_t column = 0; column < rows_[0].size(); ++column) {
        std::size_t width = 0;
        for (const Row& row : rows_) width = std::max(width, text_width(row[column]));
        const bool right = stands_right(rows_, column);
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            const std::string& cell = rows_[r][column];
            const std::string gap(width - text_width(cell), ' ');
            lines[r] += (column ? "  " : "") + (right ? gap + cell : cell + gap);
        }
    }
    std::string text;
    for (const std::string& line : lines)
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    return text;
}

}  // namespace lobe
