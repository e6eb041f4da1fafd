// SPDX-License-Identifier: Apache-2.0
// The text of a scene file and places in it, which every message of the reader names.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"

namespace lobe {

struct SourceFile {
    std::string path;                      // as messages name it
    std::string text;                      // without a byte order mark
    std::vector<std::size_t> line_starts;  // offset of each line's first byte
};

// A byte of a source file.
struct Place {
    const SourceFile* file = nullptr;
    std::size_t offset = 0;
};

// FILE:LINE:COL, counted from one; columns count bytes.
std::string to_string(const Place& place);

// Throws Error (scene) at a place.
[[noreturn]] void fail(const Place& place, const std::string& what, const std::string& hint = "");

// A class of a directive (Shape "cube") that is not known. With --lenient the directive is left
// out.
class UnknownClass : public Error {
  public:
    using Error::Error;
};

// Throws UnknownClass for `kind` ("shape \"cube\""), or Error where `later` has its name: what is
// understood but not supported yet is refused, with --lenient too.
[[noreturn]] void fail_class(const Place& place, const std::string& kind, const std::string& name,
                             const std::vector<std::string>& known,
                             const std::vector<std::string>& later);

// A number as a message shows it.
std::string show(double value);

// "choose one of: a, b, c", for hints.
std::string choices(const std::vector<std::string>& names);

// "did you mean 'NEAREST'? choose one of: ..." for a name that is none of `names`.
std::string suggestion(const std::string& name, const std::vector<std::string>& names);

// Makes a source file of text in memory. Throws Error (scene) for bytes that no text has.
std::unique_ptr<SourceFile> make_source(const std::string& path, std::string text);

// Reads a file. Throws Error (scene) if it cannot be read or is not plain text.
std::unique_ptr<SourceFile> read_source(const std::string& path);

}  // namespace lobe
