// SPDX-License-Identifier: Apache-2.0
// Device memory with a fence around it, for kernels that may write where they must not.
#pragma once

#include <CL/opencl.hpp>
#include <cstddef>
#include <cstdint>

namespace lobe {

class Device;

// On a device that works in the host's memory, the buffer ends at a page that nobody may touch and
// another stands before it: what a kernel reads or writes beyond ends the process. Elsewhere, and
// in the odd bytes between buffer and page, a pattern tells of stores, once they have happened.
class GuardedBuffer {
  public:
    // `bytes` of zeros; with `data`, a copy of that many bytes.
    GuardedBuffer(const Device& device, std::size_t bytes, const void* data = nullptr);
    ~GuardedBuffer();
    GuardedBuffer(const GuardedBuffer&) = delete;
    GuardedBuffer& operator=(const GuardedBuffer&) = delete;

    // What a kernel takes as its argument.
    const cl::Buffer& get() const { return buffer_; }

    // Whether the pattern around the buffer is as it was. Waits for the device.
    bool intact() const;

  private:
    const Device& device_;
    std::size_t bytes_;
    std::uint8_t* pages_ = nullptr;  // from the first guard page to the last
    std::size_t inner_ = 0;          // bytes between the guard pages
    std::size_t before_ = 0;         // of them before the buffer
    cl::Buffer whole_, buffer_;      // one and the same where the host's memory is used in place
};

}  // namespace lobe
