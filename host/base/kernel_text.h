// SPDX-License-Identifier: Apache-2.0
// The kernel source files: those embedded in the program, or those of a folder in their place; and
// beside them texts of the user's own.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace lobe {

class KernelText {
  public:
    // The embedded files, or the files of `folder` if it is not empty (Error device if unreadable).
    explicit KernelText(std::string folder = "");

    // Adds a text that is no file of lobe's, a user's "velvet.cl". It hides a file of that path.
    void add(const std::string& path, std::string text) { added_[path] = std::move(text); }
    bool added(const std::string& path) const { return added_.count(path) > 0; }

    // The text of e.g. "brdf/rational.h". Throws Error (device) when there is none.
    std::string read(const std::string& path) const;
    bool has(const std::string& path) const;

    // All paths, added ones too, beginning with `prefix`, sorted, e.g. list("brdf/").
    std::vector<std::string> list(const std::string& prefix) const;

  private:
    bool has_file(const std::string& path) const;

    std::string folder_;
    std::map<std::string, std::string> added_;
};

}  // namespace lobe
