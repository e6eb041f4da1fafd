// SPDX-License-Identifier: Apache-2.0
#include "lab/settings.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <cstdlib>
#include <sstream>

#include "base/error.h"
#include "lab/parameter_sweep.h"
#include "scene/measured_files.h"
#include "scene/source.h"

namespace lobe {
namespace {

[[noreturn]] void refuse(const Setting& s, const std::string& wanted) {
    throw Error(ExitCode::usage, "--set " + s.name + "=" + s.value + " is not understood", "",
                s.name + " is " + wanted);
}

std::string range_text(const BrdfParameter& p) {
    const std::string end = std::isinf(p.highest) ? "inf" : short_number(p.highest);
    return "from " + short_number(p.lowest) + " to " + end;
}

// Numbers of the row's range, or none for a text that is anything else.
std::vector<float> numbers_of(const Setting& s, const BrdfParameter& p) {
    std::vector<float> numbers;
    std::istringstream list(s.value);
    for (std::string word; std::getline(list, word, ',');) {
        char* end = nullptr;
        const auto value = static_cast<float>(std::strtod(word.c_str(), &end));
        const bool whole = p.kind != BrdfParameterKind::integer || value == std::floor(value);
        if (word.empty() || *end || !whole) return {};
        if (!(value >= static_cast<float>(p.lowest) && value <= static_cast<float>(p.highest)))
            return {};
        if (std::isinf(value) && !std::isinf(p.highest)) return {};
        numbers.push_back(value);
    }
    return numbers;
}

std::array<float, 4> row_of(const Setting& s, const BrdfParameter& p) {
    if (p.kind == BrdfParameterKind::choice) {
        const auto found = std::find(p.choices.begin(), p.choices.end(), s.value);
        if (found == p.choices.end())
            throw Error(ExitCode::usage, "--set " + s.name + " has no choice '" + s.value + "'", "",
                        suggestion(s.value, p.choices));
        return {static_cast<float>(found - p.choices.begin()), 0, 0, 0};
    }
    const std::vector<float> v = numbers_of(s, p);
    if (p.kind == BrdfParameterKind::color) {
        if (v.size() == 1) return {v[0], v[0], v[0], 0};
        if (v.size() != 3) refuse(s, "one number or three, R,G,B, " + range_text(p));
        return {v[0], v[1], v[2], 0};
    }
    if (v.size() != 1)
        refuse(s, (p.kind == BrdfParameterKind::integer ? "a whole number " : "a number ") +
                      range_text(p));
    return {v[0], 0, 0, 0};
}

// Appends the file's table; the row holds its place as bits.
std::array<float, 4> row_of_file(const std::string& path, std::vector<float>& tables) {
    MeasuredBrdf measured = read_measured(path);
    fill_gaps(measured, path);
    const auto index = static_cast<std::uint32_t>(tables.size());
    const std::vector<float> numbers = lay_out(measured);
    tables.insert(tables.end(), numbers.begin(), numbers.end());
    std::array<float, 4> row{};
    std::memcpy(row.data(), &index, sizeof index);
    return row;
}

bool is_for(const Setting& s, const BrdfTable& model) {
    return (s.model.empty() || s.model == model.name) && model.find(s.name) >= 0;
}

}  // namespace

Setting parse_setting(const std::string& text) {
    const auto equals = text.find('=');
    const auto dot = std::min(text.find('.'), equals);
    Setting s;
    if (equals != std::string::npos) {
        if (dot < equals) s.model = text.substr(0, dot);
        const std::size_t from = dot < equals ? dot + 1 : 0;
        s.name = text.substr(from, equals - from);
        s.value = text.substr(equals + 1);
    }
    if (s.name.empty() || s.value.empty())
        throw Error(ExitCode::usage, "--set '" + text + "' is not understood", "",
                    "give [MODEL.]NAME=VALUE, such as n=100, kd=0.1,0.2,0.3 or phong.n=1e6");
    return s;
}

Subject set_up(const BrdfTable& model, const std::vector<Setting>& settings) {
    Subject subject{model, model.default_rows(), {}};
    for (const BrdfParameter& p : model.parameters)
        if (p.kind == BrdfParameterKind::table && subject.tables.empty())
            subject.tables = made_up_table();
    for (const Setting& s : settings) {
        if (!is_for(s, model)) continue;
        const auto place = static_cast<std::size_t>(model.find(s.name));
        const BrdfParameter& p = model.parameters[place];
        subject.rows[place] = p.kind == BrdfParameterKind::table
                                  ? row_of_file(s.value, subject.tables)
                                  : row_of(s, p);
    }
    return subject;
}

void check_settings(const std::vector<BrdfTable>& models, const std::vector<Setting>& settings) {
    for (const Setting& s : settings) {
        std::vector<std::string> names;
        bool taken = false;
        for (const BrdfTable& model : models) {
            taken = taken || is_for(s, model);
            for (const BrdfParameter& p : model.parameters) names.push_back(p.name);
        }
        if (taken) continue;
        std::sort(names.begin(), names.end());
        names.erase(std::unique(names.begin(), names.end()), names.end());
        const std::string of = s.model.empty() ? "" : s.model + ".";
        throw Error(ExitCode::usage,
                    "--set " + of + s.name + " is a parameter of none of the models", "",
                    suggestion(s.name, names));
    }
}

std::string value_text(const BrdfParameter& p, const std::array<float, 4>& row) {
    if (p.kind == BrdfParameterKind::table) return row[0] == 0 ? "made up" : "of a file";
    if (p.kind == BrdfParameterKind::choice) {
        const auto place = static_cast<std::size_t>(row[0]);
        return place < p.choices.size() ? p.choices[place] : short_number(row[0]);
    }
    std::string text = short_number(row[0]);
    if (p.kind == BrdfParameterKind::color && (row[1] != row[0] || row[2] != row[0]))
        text += " " + short_number(row[1]) + " " + short_number(row[2]);
    return text;
}

std::string Subject::text() const {
    std::string all;
    const BrdfRows standard = model.default_rows();
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i] != standard[i])
            all += (all.empty() ? "" : ", ") + model.parameters[i].name + " " +
                   value_text(model.parameters[i], rows[i]);
    return all.empty() ? "defaults" : all;
}

const char* kind_name(BrdfParameterKind kind) {
    static const char* const names[] = {"color", "number", "integer", "choice", "table"};
    return names[static_cast<int>(kind)];
}

}  // namespace lobe
