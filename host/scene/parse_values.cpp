// SPDX-License-Identifier: Apache-2.0
#include "scene/parse_values.h"

#include <array>
#include <charconv>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lobe {

namespace {

struct TypeRow {
    const char* spelling;
    ParameterType type;
    unsigned components;  // numbers of one value, 0 where any count will do
};

constexpr std::array<TypeRow, 18> types{{
    {"float", ParameterType::number, 1},
    {"integer", ParameterType::integer, 1},
    {"bool", ParameterType::boolean, 0},
    {"string", ParameterType::string, 0},
    {"texture", ParameterType::texture, 0},
    {"rgb", ParameterType::rgb, 3},
    {"color", ParameterType::rgb, 3},
    {"xyz", ParameterType::xyz, 3},
    {"spectrum", ParameterType::spectrum, 2},
    {"blackbody", ParameterType::blackbody, 0},
    {"point", ParameterType::point3, 3},
    {"point3", ParameterType::point3, 3},
    {"point2", ParameterType::point2, 2},
    {"vector", ParameterType::vector3, 3},
    {"vector3", ParameterType::vector3, 3},
    {"vector2", ParameterType::vector2, 2},
    {"normal", ParameterType::normal, 3},
    {"normal3", ParameterType::normal, 3},
}};

const TypeRow* find_type(std::string_view spelling) {
    for (const TypeRow& row : types)
        if (spelling == row.spelling) return &row;
    return nullptr;
}

struct Declaration {
    std::string type, name;
};

// Both words of "type name", or nothing in them if there are not two.
Declaration split(const Token& token) {
    const std::string_view blanks = " \t\r";
    const std::string_view text = token.text;
    const auto words_from = [&](std::size_t at) {
        const std::size_t begin = std::min(text.find_first_not_of(blanks, at), text.size());
        const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
        return std::pair(begin, end);
    };
    const auto [type_begin, type_end] = words_from(0);
    const auto [name_begin, name_end] = words_from(type_end);
    if (name_begin == name_end || words_from(name_end).first != text.size()) return {};
    return {std::string(text.substr(type_begin, type_end - type_begin)),
            std::string(text.substr(name_begin, name_end - name_begin))};
}

std::string quote(std::string_view text) { return "'" + std::string(text) + "'"; }

void add_value(Parameter& parameter, const Token& token) {
    const bool is_boolean = parameter.type == ParameterType::boolean;
    const bool wants_text = is_boolean || parameter.type == ParameterType::string ||
                            parameter.type == ParameterType::texture;
    const std::string title = "parameter \"" + parameter.name + "\" of type " + parameter.spelling;
    const bool bare =
        token.kind == TokenKind::word && (token.text == "true" || token.text == "false");
    if (token.kind == TokenKind::quoted || (bare && is_boolean)) {
        if (!wants_text && parameter.type != ParameterType::spectrum)
            fail(token.place, title + " wants numbers, has the string " + quote(token.text));
        if (is_boolean && token.text != "true" && token.text != "false")
            fail(token.place, title + " wants true or false, has " + quote(token.text));
        parameter.bare_boolean |= bare;
        parameter.strings.push_back(unescape(token.text));
    } else {
        const auto number = parse_number(token);
        if (!number) fail(token.place, quote(token.text) + " is not a value for " + title);
        if (wants_text)
            fail(token.place, title + " wants " + (is_boolean ? "true or false" : "strings") +
                                  ", has the number " + std::string(token.text));
        parameter.numbers.push_back(*number);
        if (parameter.type == ParameterType::integer &&
            (*number != std::floor(*number) || std::fabs(*number) > 2147483647.0))
            fail(token.place, title + " wants whole numbers, has " + std::string(token.text));
    }
    if (!parameter.numbers.empty() && !parameter.strings.empty())
        fail(token.place, title + " mixes numbers and strings");
}

void check_count(const Parameter& parameter, unsigned components) {
    const std::size_t count = parameter.numbers.size();
    const std::string title = "parameter \"" + parameter.name + "\" of type " + parameter.spelling;
    if (count == 0 && parameter.strings.empty()) fail(parameter.place, title + " has no value");
    if (count == 0 || components == 0) return;
    if (count % components != 0) {
        const std::size_t wanted = (count / components + 1) * components;
        fail(parameter.place,
             title + " wants " + std::to_string(wanted) + " numbers, has " + std::to_string(count),
             "every value has " + std::to_string(components) + " numbers");
    }
    if (count > 1 || parameter.type != ParameterType::number)
        for (std::size_t i = 0; i < count; ++i)
            if (!std::isfinite(parameter.numbers[i]))
                fail(place_of_value(parameter, i), title + " has an infinite value");
}

}  // namespace

std::optional<double> parse_number(const Token& word) {
    if (word.kind != TokenKind::word) return {};
    std::string_view text = word.text;
    if (!text.empty() && text[0] == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || text.empty()) return {};
    if (error == std::errc::result_out_of_range) {
        value = std::strtod(std::string(text).c_str(), nullptr);  // zero where it is too small
        if (std::isinf(value))
            fail(word.place, "the number " + std::string(text) + " is too large");
    } else if (error != std::errc()) {
        return {};
    }
    if (std::isnan(value))
        fail(word.place, "the number " + std::string(text) + " is not a number",
             "an exporter may have divided by zero: mend or leave out the shape");
    return value;
}

bool has_known_type(const Token& declaration) {
    const Declaration words = split(declaration);
    return find_type(words.type) != nullptr;
}

Parameter parse_parameter(const Token& declaration, Lexer& lexer) {
    const Declaration words = split(declaration);
    if (words.name.empty())
        fail(declaration.place, quote(declaration.text) + " is not a parameter's type and name",
             "write it like \"float radius\"");
    const TypeRow* row = find_type(words.type);
    if (!row) {
        std::vector<std::string> names;
        for (const TypeRow& type : types) names.emplace_back(type.spelling);
        fail(declaration.place,
             "unknown parameter type '" + words.type + "' of parameter \"" + words.name + "\"",
             suggestion(words.type, names));
    }
    Parameter parameter{row->type, words.type, words.name, declaration.place, {}, {}, {}, false};
    const Token first = lexer.next();
    const bool is_list = first.kind == TokenKind::open;
    parameter.values_place = is_list ? lexer.peek().place : first.place;
    Token token = is_list ? lexer.next() : first;
    while (token.kind == TokenKind::word || token.kind == TokenKind::quoted) {
        add_value(parameter, token);
        if (!is_list) break;
        token = lexer.next();
    }
    if (is_list && token.kind != TokenKind::close)
        fail(first.place, "a list of values that does not end", "close it with ]");
    check_count(parameter, row->components);
    return parameter;
}

void skip_values(Lexer& lexer) {
    const Token first = lexer.next();
    if (first.kind != TokenKind::open) return;
    for (Token token = lexer.next(); token.kind != TokenKind::close; token = lexer.next())
        if (token.kind == TokenKind::end)
            fail(first.place, "a list of values that does not end", "close it with ]");
}

Place place_of_value(const Parameter& parameter, std::size_t i) {
    Lexer lexer(*parameter.values_place.file, parameter.values_place.offset);
    for (; i > 0; --i) lexer.next();
    return lexer.next().place;
}

const char* type_name(ParameterType type) {
    for (const TypeRow& row : types)
        if (row.type == type) return row.spelling;
    return "";
}

}  // namespace lobe
