// SPDX-License-Identifier: Apache-2.0
// The kernel source files: those embedded in the program, or those of a folder in their place.
#pragma once

#include <string>
#include <vector>

namespace lobe {

class KernelText {
  public:
    // The embedded files, or the files of `folder` if it is not empty (Error device if unreadable).
    explicit KernelText(std::string folder = "");

    // The text of e.g. "brdf/rational.h". Throws Error (device) when there is none.
    std::string read(const std::string& path) const;
    bool has(const std::string& path) const;

    // All paths beginning with `prefix`, sorted, e.g. list("brdf/").
    std::vector<std::string> list(const std::string& prefix) const;

  private:
    std::string folder_;
};

}  // namespace lobe
