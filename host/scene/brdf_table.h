// SPDX-License-Identifier: Apache-2.0
// The parameter table of a reflectance model, read from the model's own kernel file.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace lobe {

class KernelText;

enum class BrdfParameterKind { color, number, integer, choice, table };

struct BrdfParameter {
    BrdfParameterKind kind;
    std::string name;
    double standard, lowest, highest;  // default and closed range; each channel of a colour
    std::vector<std::string> choices;  // of a choice, in order of their numbers
    std::string meaning;
};

struct BrdfTable {
    std::string name;  // "rational"
    std::string file;  // "brdf/rational.h", or a user's own as typed
    std::string doc;   // the file's first comment, lines without their slashes
    bool has_formula;  // whether it defines NAME_formula
    std::vector<BrdfParameter> parameters;
    bool own = false;  // a user's own file, not one of lobe's kernels

    // The doc block's first sentence.
    std::string title() const;
    // Place of a parameter by name, or -1.
    int find(const std::string& parameter) const;
    // One row a parameter, filled with the defaults.
    std::vector<std::array<float, 4>> default_rows() const;
};

// The table in a kernel file's text. Throws Error (scene) with FILE:LINE:COL for a row that is not
// P(kind, name, default, lowest, highest, "meaning") or whose default lies outside its range.
BrdfTable parse_brdf_table(const std::string& file, const std::string& text);

// All models, sorted by name: the files of kernels/brdf that define NAME_parameters, and the texts
// added to the kernels that do.
std::vector<BrdfTable> read_brdf_tables(const KernelText& kernels);

}  // namespace lobe
