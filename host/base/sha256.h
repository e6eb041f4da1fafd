// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace lobe {

// SHA-256 as 64 lower-case hexadecimal digits, fed in pieces.
class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(const void* data, std::size_t bytes);
    void add(const std::string& text) { add(text.data(), text.size()); }
    std::string hex();  // ends the sum: call once

  private:
    struct State;
    std::unique_ptr<State> state_;
};

std::string sha256(const std::string& text);

}  // namespace lobe
