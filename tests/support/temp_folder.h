// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lobe::test {

// A new folder that goes, with what is in it, when this object does.
class TempFolder {
  public:
    TempFolder();
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::string& path() const { return path_; }
    std::string file(const std::string& name) const { return path_ + "/" + name; }
    // Writes a file and gives its path.
    std::string write(const std::string& name, const std::string& bytes) const;

  private:
    std::string path_;
};

// An environment variable with another value (or none, if null) for a while.
class ScopedVariable {
  public:
    ScopedVariable(const char* name, const char* value);
    ~ScopedVariable();
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;

  private:
    std::string name_, old_;
    bool had_;
};

}  // namespace lobe::test
