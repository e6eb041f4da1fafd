// SPDX-License-Identifier: Apache-2.0
// Device memory with a type, an owner and an entry in the device's account.
#pragma once

#include <CL/opencl.hpp>
#include <type_traits>
#include <utility>
#include <vector>

#include "cl/cl_error.h"
#include "cl/device.h"
#include "cl/large_pages.h"

namespace lobe {

// All transfers wait until they are done. `what` names the buffer in an error about memory.
template <typename T>
class Buffer {
    static_assert(std::is_trivially_copyable<T>::value, "devices take bytes");

  public:
    // `count` elements of undefined content, that kernels may read and write.
    Buffer(const Device& device, std::size_t count, const char* what = "a buffer")
        : Buffer(device, count, CL_MEM_READ_WRITE, what) {}

    // A copy of `data` for kernels to read. One undefined element stands for an empty vector.
    Buffer(const Device& device, const std::vector<T>& data, const char* what = "a buffer")
        : Buffer(device, data.size(), CL_MEM_READ_ONLY, what) {
        write(data.data(), data.size());
    }

    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        Buffer(std::move(other)).swap(*this);
        return *this;
    }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    ~Buffer() {
        buffer_ = cl::Buffer();  // the memory first, then its entry
        if (account_) account_->release(bytes_);
    }

    // Elements [offset, offset + count) from and to the host.
    void read(T* to, std::size_t count, std::size_t offset = 0) const {
        if (!count) return;
        checked([&] {
            queue_.enqueueReadBuffer(buffer_, CL_TRUE, offset * sizeof(T), count * sizeof(T), to);
        });
    }
    void write(const T* from, std::size_t count, std::size_t offset = 0) {
        if (!count) return;
        checked([&] {
            queue_.enqueueWriteBuffer(buffer_, CL_TRUE, offset * sizeof(T), count * sizeof(T),
                                      from);
        });
    }
    std::vector<T> read_all() const {
        std::vector<T> data(count_);
        read(data.data(), count_);
        return data;
    }

    // Sets all bytes to zero; not finished when it returns, but before any later work of the queue.
    void fill_zero() {
        checked([&] { queue_.enqueueFillBuffer(buffer_, cl_uchar{0}, 0, bytes_); });
    }

    std::size_t count() const { return count_; }
    std::size_t bytes() const { return bytes_; }
    const cl::Buffer& get() const { return buffer_; }

  private:
    Buffer(const Device& device, std::size_t count, cl_mem_flags flags, const char* what)
        : queue_(device.queue()), count_(count) {
        const std::size_t allocated = count ? count : 1;  // OpenCL has no empty buffers
        bytes_ = device.memory()->reserve(allocated, sizeof(T), what);
        account_ = device.memory();
        // A CPU takes memory of the host's for its own.
        if (device.info().type & CL_DEVICE_TYPE_CPU) host_memory_ = large_pages(bytes_);
        if (host_memory_) flags |= CL_MEM_USE_HOST_PTR;
        try {
            buffer_ = checked(
                [&] { return cl::Buffer(device.context(), flags, bytes_, host_memory_.get()); });
        } catch (...) {
            account_->release(bytes_);
            throw;
        }
    }
    void swap(Buffer& other) noexcept {
        std::swap(queue_, other.queue_);
        std::swap(buffer_, other.buffer_);
        std::swap(account_, other.account_);
        std::swap(count_, other.count_);
        std::swap(bytes_, other.bytes_);
        std::swap(host_memory_, other.host_memory_);
    }

    cl::CommandQueue queue_;
    cl::Buffer buffer_;
    std::shared_ptr<MemoryAccount> account_;
    std::size_t count_ = 0, bytes_ = 0;
    std::shared_ptr<void> host_memory_;  // where the device's memory is ours
};

}  // namespace lobe
