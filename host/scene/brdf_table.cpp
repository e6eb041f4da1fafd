// SPDX-License-Identifier: Apache-2.0
#include "scene/brdf_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "base/kernel_text.h"

namespace lobe {

namespace {

// The text of a macro's body with the line it stands on.
struct Body {
    std::string name, text;
    std::size_t line;
};

// The definition of NAME_parameters(P), continuation lines joined by newlines.
Body find_body(const std::string& text) {
    static const std::regex define(
        R"(#define[ \t]+([a-z][a-z0-9_]*)_parameters\(P\)[ \t]*\\\r?\n)");
    std::smatch match;
    if (!std::regex_search(text, match, define)) return {};
    Body body{match[1], "", 1};
    std::size_t at = static_cast<std::size_t>(match.position() + match.length());
    body.line += static_cast<std::size_t>(
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    for (bool more = true; more;) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string line = text.substr(at, end - at);
        while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
        more = !line.empty() && line.back() == '\\' && end < text.size();
        if (more) line.pop_back();
        body.text += line + "\n";
        at = end + 1;
    }
    return body;
}

double bound(const std::string& word) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    return *end ? std::nan("") : value;
}

std::vector<std::string> split_choices(const std::string& meaning) {
    std::vector<std::string> names;
    const std::string list = meaning.substr(0, meaning.find(':'));
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t end = std::min(list.find('|', at), list.size());
        names.push_back(list.substr(at, end - at));
        at = end + 1;
    }
    return names;
}

// What is wrong with a row whose form is right, or "".
std::string fault_of(const BrdfParameter& row, const std::vector<BrdfParameter>& before) {
    if (std::isnan(row.standard) || std::isnan(row.lowest) || std::isnan(row.highest))
        return "default and bounds must be numbers";
    if (!(row.lowest <= row.standard && row.standard <= row.highest))
        return "the default lies outside its range";
    for (const BrdfParameter& other : before)
        if (other.name == row.name) return "the name comes twice";
    if (row.kind == BrdfParameterKind::integer && row.standard != std::floor(row.standard))
        return "the default of an integer is no whole number";
    if (row.kind != BrdfParameterKind::choice) return "";
    if (row.meaning.find(':') == std::string::npos || row.choices.size() < 2)
        return "the meaning of a choice begins with its names, \"first|second: meaning\"";
    for (const std::string& name : row.choices)
        if (name.empty() || name.find(' ') != std::string::npos) return "a choice needs a name";
    if (row.lowest != 0 || row.highest != static_cast<double>(row.choices.size() - 1))
        return "the bounds of a choice are 0 and the number of its last name";
    return row.standard == std::floor(row.standard) ? "" : "the default of a choice is its number";
}

BrdfParameterKind kind_of(const std::string& word) {
    if (word == "color") return BrdfParameterKind::color;
    if (word == "number") return BrdfParameterKind::number;
    if (word == "table") return BrdfParameterKind::table;
    return word == "integer" ? BrdfParameterKind::integer : BrdfParameterKind::choice;
}

// The first run of // lines after the licence line, which has an SPDX tag.
std::string doc_block(const std::string& text) {
    std::string doc;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.find("SPDX-License-Identifier") != std::string::npos) continue;
        if (line.compare(0, 2, "//") != 0) {
            if (doc.empty() && line.empty()) continue;
            break;
        }
        doc += (line.compare(0, 3, "// ") == 0 ? line.substr(3) : line.substr(2)) + "\n";
    }
    return doc;
}

// Whether a function of that name is written at the beginning of a line.
bool defines(const std::string& text, const std::string& function) {
    return text.find("\nreal3 " + function + "(") != std::string::npos;
}

}  // namespace

std::string BrdfTable::title() const {
    std::string sentence = doc.substr(0, doc.find("\n\n"));
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    const std::size_t end = sentence.find(". ");
    return end == std::string::npos ? sentence : sentence.substr(0, end + 1);
}

int BrdfTable::find(const std::string& parameter) const {
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (parameters[i].name == parameter) return static_cast<int>(i);
    return -1;
}

std::vector<std::array<float, 4>> BrdfTable::default_rows() const {
    std::vector<std::array<float, 4>> rows;
    for (const BrdfParameter& parameter : parameters) {
        const auto value = static_cast<float>(parameter.standard);
        const bool colour = parameter.kind == BrdfParameterKind::color;
        rows.push_back({value, colour ? value : 0, colour ? value : 0, 0});
    }
    return rows;
}

BrdfTable parse_brdf_table(const std::string& file, const std::string& text) {
    static const std::regex form(
        R"re(\s*P\(\s*(color|number|integer|choice|table)\s*,\s*([A-Za-z]\w*)\s*,\s*([-+.\w]+)\s*,)re"
        R"re(\s*([-+.\w]+)\s*,\s*([-+.\w]+)\s*,\s*"([^"\n]*)"\s*\)[ \t]*)re");
    const Body body = find_body(text);
    if (body.name.empty())
        throw Error(ExitCode::scene, "no table NAME_parameters(P) with its rows", file + ":1:1",
                    "kernels/brdf/README.md shows the form");
    BrdfTable table{body.name, file, doc_block(text), defines(text, body.name + "_formula"), {}};
    std::size_t line = body.line;
    auto at = body.text.begin(), line_start = at;
    const auto advance = [&](const auto& to) {
        for (; at != to; ++at) {
            if (*at != '\n') continue;
            ++line;
            line_start = at + 1;
        }
    };
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    for (;;) {
        advance(std::find_if_not(at, body.text.end(), blank));
        if (at == body.text.end()) break;
        const std::string where =
            file + ":" + std::to_string(line) + ":" + std::to_string(at - line_start + 1);
        std::smatch match;
        if (!std::regex_search(at, body.text.end(), match, form,
                               std::regex_constants::match_continuous))
            throw Error(ExitCode::scene, "a row of " + table.name + "_parameters is malformed",
                        where,
                        "P(color|number|integer|choice|table, name, default, lowest, highest, "
                        "\"meaning\")");
        BrdfParameter row{kind_of(match[1]), match[2], bound(match[3]), bound(match[4]),
                          bound(match[5]),   {},       match[6]};
        if (row.kind == BrdfParameterKind::choice) row.choices = split_choices(row.meaning);
        const std::string fault = fault_of(row, table.parameters);
        if (!fault.empty())
            throw Error(ExitCode::scene, fault + " (" + table.name + "'s " + row.name + ")", where);
        table.parameters.push_back(std::move(row));
        advance(match[0].second);
    }
    return table;
}

std::vector<BrdfTable> read_brdf_tables(const KernelText& kernels) {
    static const std::regex defines(R"(#define[ \t]+[a-z][a-z0-9_]*_parameters\(P\))");
    std::vector<BrdfTable> tables;
    for (const std::string& path : kernels.list("")) {
        const bool own = kernels.added(path);
        const bool header = path.size() > 2 && path.compare(path.size() - 2, 2, ".h") == 0;
        if (!own && !(header && path.compare(0, 5, "brdf/") == 0)) continue;
        const std::string text = kernels.read(path);
        if (!std::regex_search(text, defines)) continue;
        tables.push_back(parse_brdf_table(path, text));
        tables.back().own = own;
    }
    std::sort(tables.begin(), tables.end(),
              [](const BrdfTable& a, const BrdfTable& b) { return a.name < b.name; });
    return tables;
}

}  // namespace lobe
