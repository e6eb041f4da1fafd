// SPDX-License-Identifier: Apache-2.0
// Parts of the program that are opened on demand, since what they link is large.
#pragma once

#include <string>

namespace lobe {

// A module by its file's name, from beside the program (in a build), from ../lib/lobe (of an
// installation) or from where the system looks. It is never closed: libraries it brings in do not
// survive that.
class Module {
  public:
    explicit Module(const std::string& name);

    // A function that it exports; null if there is no module or no such function.
    template <typename Pointer>
    Pointer function(const char* name) const {
        return reinterpret_cast<Pointer>(find(name));
    }

    // Why it could not be opened, or "".
    const std::string& error() const { return error_; }

  private:
    void* find(const char* name) const;

    void* handle_ = nullptr;
    std::string error_;
};

}  // namespace lobe
