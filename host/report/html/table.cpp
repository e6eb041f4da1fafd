// SPDX-License-Identifier: Apache-2.0
#include <cctype>

#include "report/html/base64.h"
#include "report/html/parts.h"
#include "report/markup.h"
#include "report/text_table.h"

namespace lobe {
namespace {

using Row = std::vector<std::string>;

std::vector<Row> shown(const ReportTable& table) {
    std::vector<Row> rows = {table.head};
    rows.insert(rows.end(), table.rows.begin(), table.rows.end());
    for (Row& row : rows) row.resize(table.head.size());
    return rows;
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

// Letters and digits of a title, words joined: "Equal time" -> "equal-time.csv".
std::string file_name(const std::string& title) {
    std::string name;
    for (const char c : title) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80 && std::isalnum(byte))
            name += static_cast<char>(std::tolower(byte));
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (!name.empty() && name.back() == '-') name.pop_back();
    return (name.empty() ? "table" : name) + ".csv";
}

}  // namespace

std::string csv_of(const ReportTable& table) {
    std::string text;
    for (const Row& row : table.csv.empty() ? shown(table) : table.csv) {
        for (std::size_t c = 0; c < row.size(); ++c) text += (c ? "," : "") + csv_cell(row[c]);
        text += "\r\n";
    }
    return text;
}

std::string table_html(const ReportTable& table) {
    if (table.head.empty()) return "";
    const std::vector<Row> rows = shown(table);
    std::string out = "<div class=\"table\"><table>\n<caption>" + markup_text(table.title) +
                      " <a class=\"csv\" download=\"" + file_name(table.title) + "\" href=\"" +
                      data_uri("text/csv;charset=utf-8", csv_of(table)) + "\">CSV</a></caption>\n";
    for (std::size_t r = 0; r < rows.size(); ++r) {
        out += r == 0 ? "<thead><tr>" : "<tr>";
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            const std::string tag = r == 0 ? "th" : "td";
            out += "<" + tag + (r == 0 ? " scope=\"col\"" : "") +
                   (stands_right(rows, c) ? " class=\"number\">" : ">") + markup_text(rows[r][c]) +
                   "</" + tag + ">";
        }
        out += r == 0 ? "</tr></thead>\n<tbody>\n" : "</tr>\n";
    }
    out += "</tbody></table></div>\n";
    if (!table.note.empty()) out += "<p class=\"note\">" + markup_text(table.note) + "</p>\n";
    return out;
}

}  // namespace lobe
