// SPDX-License-Identifier: Apache-2.0
// A scene file with all files it includes, parsed but not yet understood.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scene/syntax.h"

namespace lobe {

// Includes nested deeper than this are taken for a mistake.
constexpr std::size_t include_depth_limit = 32;

struct ParsedFile {
    std::unique_ptr<SourceFile> source;
    std::vector<Statement> statements;
    std::vector<ParsedFile*> includes;  // of its Include and Import statements, in order
};

class SceneFiles {
  public:
    // Reads the scene file and, once each, what it includes. Throws Error (scene) for files that
    // are missing or malformed, that include themselves, or that nest too deep.
    SceneFiles(const std::string& path, bool lenient, std::vector<std::string>& warnings);

    const ParsedFile& root() const { return *order_.front(); }
    const std::vector<std::unique_ptr<ParsedFile>>& in_reading_order() const { return order_; }

  private:
    ParsedFile* parse(const std::string& path);

    bool lenient_;
    std::vector<std::string>& warnings_;
    std::vector<std::unique_ptr<ParsedFile>> order_;
    std::map<std::string, ParsedFile*> by_path_;
};

// "A includes B includes C", for messages about a chain of files.
std::string show_chain(const std::vector<const ParsedFile*>& chain);

// The path a file names, relative to the folder of the file at `place` or, where there is no such
// file, to `root_folder`.
std::string resolve_path(const std::string& name, const Place& place,
                         const std::string& root_folder);

// The folder part of a path, or "".
std::string folder_of(const std::string& path);

}  // namespace lobe
