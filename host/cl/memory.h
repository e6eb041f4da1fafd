// SPDX-License-Identifier: Apache-2.0
// The account of a device's memory. Drivers promise more than they have (PoCL "allocates" 128 GiB
// of 8), so lobe keeps its own and refuses first.
#pragma once

#include <cstdint>
#include <string>

namespace lobe {

class MemoryAccount {
  public:
    // Bytes of the device's memory, and the most that one buffer may have.
    MemoryAccount(std::uint64_t total, std::uint64_t largest) : total_(total), largest_(largest) {}

    // Enters `count` elements of `size` bytes and gives the bytes. Throws Error (device) that says
    // how much `what` needs and how much there is, and then enters nothing.
    std::uint64_t reserve(std::uint64_t count, std::uint64_t size, const std::string& what);
    void release(std::uint64_t bytes) { used_ -= bytes; }

    std::uint64_t total() const { return total_; }
    std::uint64_t largest() const { return largest_; }
    std::uint64_t used() const { return used_; }
    std::uint64_t peak() const { return peak_; }

  private:
    std::uint64_t total_, largest_, used_ = 0, peak_ = 0;
};

}  // namespace lobe
