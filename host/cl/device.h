// SPDX-License-Identifier: Apache-2.0
// Which OpenCL devices there are, and the one that works for us.
#pragma once

#include <CL/opencl.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cl/memory.h"

namespace lobe {

struct DeviceInfo {
    unsigned number = 0;  // place in list_devices(), what --device takes
    std::string name, platform, vendor, driver, version, opencl_c;
    cl_device_type type = 0;
    unsigned compute_units = 0, clock_mhz = 0;
    std::uint64_t global_memory = 0, largest_allocation = 0;  // bytes
    bool fp64 = false;                                        // cl_khr_fp64
    bool shares_host_memory = false;                          // as integrated GPUs do
    bool correctly_rounded = false;                           // divide and sqrt on request
    std::string extensions;
};

// "GPU", "CPU" or "accelerator".
const char* device_type_name(cl_device_type type);

// All devices that can compile kernels, in the order of their platforms. Throws Error (device) with
// what to install if there is none.
std::vector<DeviceInfo> list_devices();

// The place in `devices` of the one that `choice` means: a number, a part of a device's or
// platform's name in any case, or "" for the one likely to be fastest (GPU before accelerator
// before CPU, then compute units times clock). Throws Error (device) with the list if none is
// meant.
std::size_t choose_device(const std::vector<DeviceInfo>& devices, const std::string& choice);

// The same; where `choice` is empty, the environment's LOBE_DEVICE decides.
std::size_t chosen_device(const std::vector<DeviceInfo>& devices, const std::string& choice);

// What to do about failures without a word from a driver that needs a writable cache folder: PoCL
// shows no device or builds nothing without it. "" for other platforms.
std::string cache_hint(const std::string& platform);

// A device with a context and one in-order queue. To be owned by main, never
// static.
class Device {
  public:
    Device(cl::Device device, DeviceInfo info);
    Device(Device&&) = default;
    Device& operator=(Device&&) = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const DeviceInfo& info() const { return info_; }
    const cl::Device& device() const { return device_; }
    const cl::Context& context() const { return context_; }
    const cl::CommandQueue& queue() const { return queue_; }
    const std::shared_ptr<MemoryAccount>& memory() const { return memory_; }

    // Waits until all work in the queue is done.
    void finish() const;

  private:
    DeviceInfo info_;
    cl::Device device_;
    cl::Context context_;
    cl::CommandQueue queue_;
    std::shared_ptr<MemoryAccount> memory_;
};

// Opens the chosen_device().
Device open_device(const std::string& choice = "");

}  // namespace lobe
