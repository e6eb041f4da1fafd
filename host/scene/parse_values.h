// SPDX-License-Identifier: Apache-2.0
// Reads the values of parameters and directives: numbers, booleans and strings.
#pragma once

#include <optional>

#include "scene/syntax.h"

namespace lobe {

// A word as a number, infinite for inf; nothing if it is none. Throws Error (scene) for NaN and for
// numbers too large for a double.
std::optional<double> parse_number(const Token& word);

// The parameter whose declaration, "type name", is `declaration`, with its values from the lexer.
// Throws Error (scene) for a type that is unknown, and for values that are not of the type.
Parameter parse_parameter(const Token& declaration, Lexer& lexer);

// Whether the first word of a declaration is a type.
bool has_known_type(const Token& declaration);

// Passes over one value or bracketed list.
void skip_values(Lexer& lexer);

}  // namespace lobe
