// SPDX-License-Identifier: Apache-2.0
#include "lab/trial/guarded_buffer.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/error.h"
#include "cl/cl_error.h"
#include "cl/device.h"

namespace lobe {
namespace {

constexpr std::uint8_t pattern = 0xa5;
constexpr std::size_t guard = 1 << 20;  // bytes that nobody may touch, on either side
constexpr std::size_t margin = 4096;    // of pattern on either side, on devices with own memory

std::size_t round_up(std::size_t value, std::size_t step) {
    return (value + step - 1) / step * step;
}

bool untouched(const std::uint8_t* bytes, std::size_t count) {
    return std::all_of(bytes, bytes + count, [](std::uint8_t byte) { return byte == pattern; });
}

}  // namespace

GuardedBuffer::GuardedBuffer(const Device& device, std::size_t bytes, const void* data)
    : device_(device), bytes_(std::max<std::size_t>(bytes, 1)) {
    const bool in_place = device.info().type & CL_DEVICE_TYPE_CPU;
    // In place it begins where the largest vector may, else where parts of buffers may.
    const std::size_t after = in_place ? 0 : margin;
    const std::size_t room = round_up(bytes_, in_place ? sizeof(cl_double16) : margin);
    inner_ = round_up(room + 2 * after, static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
    before_ = inner_ - room - after;
    void* const pages = mmap(nullptr, inner_ + 2 * guard, PROT_NONE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (pages == MAP_FAILED) throw Error(ExitCode::device, "the host's memory is used up");
    pages_ = static_cast<std::uint8_t*>(pages);
    std::uint8_t* const inner = pages_ + guard;
    mprotect(inner, inner_, PROT_READ | PROT_WRITE);
    std::memset(inner, pattern, before_);
    std::memset(inner + before_ + bytes_, pattern, inner_ - before_ - bytes_);
    if (data) std::memcpy(inner + before_, data, bytes);
    const cl_mem_flags flags = CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR;
    if (in_place) {
        whole_ = buffer_ =
            checked([&] { return cl::Buffer(device.context(), flags, bytes_, inner + before_); });
    } else {
        whole_ = checked([&] { return cl::Buffer(device.context(), flags, inner_, inner); });
        const cl_buffer_region region{before_, bytes_};
        buffer_ = checked([&] {
            cl_int status = CL_SUCCESS;
            cl::Buffer part = whole_.createSubBuffer(
                CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION, &region, &status);
            return part;
        });
    }
}

GuardedBuffer::~GuardedBuffer() {
    buffer_ = cl::Buffer();
    whole_ = cl::Buffer();
    munmap(pages_, inner_ + 2 * guard);
}

bool GuardedBuffer::intact() const {
    const std::size_t end = before_ + bytes_;
    if (device_.info().type & CL_DEVICE_TYPE_CPU) {
        device_.finish();
        return untouched(pages_ + guard, before_) && untouched(pages_ + guard + end, inner_ - end);
    }
    std::vector<std::uint8_t> first(before_), last(inner_ - end);
    checked([&] {
        device_.queue().enqueueReadBuffer(whole_, CL_TRUE, 0, before_, first.data());
        device_.queue().enqueueReadBuffer(whole_, CL_TRUE, end, inner_ - end, last.data());
    });
    return untouched(first.data(), first.size()) && untouched(last.data(), last.size());
}

}  // namespace lobe
