// SPDX-License-Identifier: Apache-2.0
// A scene file as a list of directives with typed parameters, before anything is understood.
#pragma once

#include <string>
#include <vector>

#include "scene/lexer.h"

namespace lobe {

enum class ParameterType {
    boolean,
    integer,
    number,
    point2,
    point3,
    vector2,
    vector3,
    normal,
    rgb,
    xyz,
    spectrum,
    blackbody,
    string,
    texture,
};

// "float radius" [ 3 ]. Numbers are counted and checked against the type; a value is finite, or
// infinite where the file says `inf` for a single float.
struct Parameter {
    ParameterType type;
    std::string spelling;  // the type as written: "color"
    std::string name;
    Place place;         // of the quoted declaration
    Place values_place;  // of the first value
    std::vector<double> numbers;
    std::vector<std::string> strings;  // of bool: "true" and "false"
    bool bare_boolean = false;         // true, not "true"
};

// A quoted string: a directive's class, a name.
struct Word {
    std::string text;
    Place place;
};

// One directive: its fixed arguments in order, then its parameters.
struct Statement {
    std::string name;
    Place place;
    std::vector<Word> strings;
    std::vector<double> numbers;
    std::vector<Parameter> parameters;

    // "Shape "sphere"", as messages name it.
    std::string title() const;
};

// Where value i of a parameter stands in its file.
Place place_of_value(const Parameter& parameter, std::size_t i);

// The word of a type, "float", and of its plural use in messages.
const char* type_name(ParameterType type);

// All names of directives, sorted.
std::vector<std::string> directive_names();

// Parses a file. Throws Error (scene) at the first fault; with `lenient`, unknown directives and
// parameter types are skipped and told in `warnings`.
std::vector<Statement> parse_statements(const SourceFile& file, bool lenient,
                                        std::vector<std::string>& warnings);

}  // namespace lobe
