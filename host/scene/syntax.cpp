// SPDX-License-Identifier: Apache-2.0
#include "scene/syntax.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "scene/parse_values.h"

namespace lobe {

namespace {

// What follows each directive: n a number, s a string, m a matrix of 16 numbers, w a bare word,
// ? makes the last optional, p a list of parameters.
const std::unordered_map<std::string_view, const char*>& directives() {
    static const std::unordered_map<std::string_view, const char*> table{
        {"Accelerator", "sp"},
        {"ActiveTransform", "w"},
        {"AreaLightSource", "sp"},
        {"Attribute", "sp"},
        {"AttributeBegin", ""},
        {"AttributeEnd", ""},
        {"Camera", "sp"},
        {"ColorSpace", "s"},
        {"ConcatTransform", "m"},
        {"CoordSysTransform", "s"},
        {"CoordinateSystem", "s"},
        {"Film", "sp"},
        {"Identity", ""},
        {"Import", "s"},
        {"Include", "s"},
        {"Integrator", "sp"},
        {"LightSource", "sp"},
        {"LookAt", "nnnnnnnnn"},
        {"MakeNamedMaterial", "sp"},
        {"MakeNamedMedium", "sp"},
        {"Material", "sp"},
        {"MediumInterface", "ss?"},
        {"NamedMaterial", "s"},
        {"ObjectBegin", "s"},
        {"ObjectEnd", ""},
        {"ObjectInstance", "s"},
        {"Option", "p"},
        {"PixelFilter", "sp"},
        {"Renderer", "sp"},
        {"ReverseOrientation", ""},
        {"Rotate", "nnnn"},
        {"Sampler", "sp"},
        {"Scale", "nnn"},
        {"Shape", "sp"},
        {"SurfaceIntegrator", "sp"},
        {"Texture", "sssp"},
        {"Transform", "m"},
        {"TransformBegin", ""},
        {"TransformEnd", ""},
        {"TransformTimes", "nn"},
        {"Translate", "nnn"},
        {"Volume", "sp"},
        {"VolumeIntegrator", "sp"},
        {"WorldBegin", ""},
        {"WorldEnd", ""},
    };
    return table;
}

void read_numbers(Statement& statement, Lexer& lexer, std::size_t count) {
    const Place start = statement.place;
    for (std::size_t i = 0; i < count; ++i) {
        const Token token = lexer.peek();
        const auto number = parse_number(token);
        if (!number || !std::isfinite(*number)) {
            const bool ended = token.kind != TokenKind::word || directives().count(token.text);
            if (ended)
                fail(start, statement.name + " wants " + std::to_string(count) + " numbers, has " +
                                std::to_string(i));
            fail(token.place,
                 statement.name + " wants finite numbers, has '" + std::string(token.text) + "'");
        }
        statement.numbers.push_back(*number);
        lexer.next();
    }
}

void read_matrix(Statement& statement, Lexer& lexer) {
    const bool bracketed = lexer.peek().kind == TokenKind::open;
    if (bracketed) lexer.next();
    read_numbers(statement, lexer, 16);
    if (bracketed && lexer.peek().kind != TokenKind::close)
        fail(statement.place, statement.name + " wants 16 numbers, has more");
    if (bracketed) lexer.next();
}

void read_string(Statement& statement, Lexer& lexer, char kind, bool optional) {
    const TokenKind wanted = kind == 'w' ? TokenKind::word : TokenKind::quoted;
    const bool bracketed = lexer.peek().kind == TokenKind::open;  // as some exporters write
    if (bracketed) lexer.next();
    const Token token = lexer.peek();
    if (token.kind != wanted) {
        if (optional && !bracketed) return;
        fail(statement.place,
             statement.name + " wants a " + (kind == 'w' ? "word" : "quoted string"));
    }
    lexer.next();
    statement.strings.push_back({unescape(token.text), token.place});
    if (bracketed && lexer.next().kind != TokenKind::close)
        fail(token.place, statement.name + " wants one string in its brackets");
}

void read_parameters(Statement& statement, Lexer& lexer, bool lenient,
                     std::vector<std::string>& warnings) {
    while (lexer.peek().kind == TokenKind::quoted) {
        const Token declaration = lexer.next();
        if (lenient && !has_known_type(declaration)) {
            warnings.push_back(to_string(declaration.place) + ": parameter '" +
                               std::string(declaration.text) + "' of unknown type is left out");
            skip_values(lexer);
            continue;
        }
        statement.parameters.push_back(parse_parameter(declaration, lexer));
    }
}

void skip_unknown(const Token& word, Lexer& lexer, std::vector<std::string>& warnings) {
    warnings.push_back(to_string(word.place) + ": unknown directive '" + std::string(word.text) +
                       "' is left out");
    for (; lexer.peek().kind != TokenKind::end; lexer.next())
        if (lexer.peek().kind == TokenKind::word && directives().count(lexer.peek().text)) return;
}

}  // namespace

std::string Statement::title() const {
    if (strings.empty()) return name;
    return name + " \"" + strings[0].text + "\"";
}

std::vector<std::string> directive_names() {
    std::vector<std::string> names;
    for (const auto& row : directives()) names.emplace_back(row.first);
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<Statement> parse_statements(const SourceFile& file, bool lenient,
                                        std::vector<std::string>& warnings) {
    std::vector<Statement> statements;
    Lexer lexer(file);
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
        const auto row = directives().find(token.text);
        if (token.kind != TokenKind::word)
            fail(token.place, "a directive was expected, not '" + std::string(token.text) + "'");
        if (row == directives().end()) {
            if (!lenient)
                fail(token.place, "unknown directive '" + std::string(token.text) + "'",
                     suggestion(std::string(token.text), directive_names()));
            skip_unknown(token, lexer, warnings);
            continue;
        }
        Statement statement{std::string(token.text), token.place, {}, {}, {}};
        const std::string_view form = row->second;
        const std::size_t numbers = std::count(form.begin(), form.end(), 'n');
        if (numbers) read_numbers(statement, lexer, numbers);
        for (std::size_t i = 0; i < form.size(); ++i) {
            if (form[i] == 'm') read_matrix(statement, lexer);
            if (form[i] == 's' || form[i] == 'w')
                read_string(statement, lexer, form[i], form.substr(i + 1, 1) == "?");
            if (form[i] == 'p') read_parameters(statement, lexer, lenient, warnings);
        }
        statements.push_back(std::move(statement));
    }
    return statements;
}

}  // namespace lobe
