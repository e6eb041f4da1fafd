// SPDX-License-Identifier: Apache-2.0
#include "cl/device.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <tuple>

#include "base/error.h"
#include "cl/cl_error.h"

namespace lobe {

namespace {

struct Found {
    cl::Device device;
    DeviceInfo info;
};

// Drivers pad names with blanks and zero bytes.
std::string trimmed(std::string text) {
    while (!text.empty() && (text.back() == '\0' || std::isspace((unsigned char)text.back())))
        text.pop_back();
    std::size_t begin = 0;
    while (begin < text.size() && std::isspace((unsigned char)text[begin])) ++begin;
    return text.substr(begin);
}

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

DeviceInfo describe(const cl::Device& device, const std::string& platform) {
    DeviceInfo info;
    info.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
    info.platform = platform;
    info.vendor = trimmed(device.getInfo<CL_DEVICE_VENDOR>());
    info.driver = trimmed(device.getInfo<CL_DRIVER_VERSION>());
    info.version = trimmed(device.getInfo<CL_DEVICE_VERSION>());
    info.opencl_c = trimmed(device.getInfo<CL_DEVICE_OPENCL_C_VERSION>());
    info.type = device.getInfo<CL_DEVICE_TYPE>();
    info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    info.shares_host_memory = device.getInfo<CL_DEVICE_HOST_UNIFIED_MEMORY>() != CL_FALSE;
    info.clock_mhz = device.getInfo<CL_DEVICE_MAX_CLOCK_FREQUENCY>();
    info.global_memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    info.largest_allocation = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    info.extensions = trimmed(device.getInfo<CL_DEVICE_EXTENSIONS>());
    info.fp64 = (" " + info.extensions + " ").find(" cl_khr_fp64 ") != std::string::npos;
    info.correctly_rounded =
        device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT;
    return info;
}

std::string no_device_hint(const std::vector<std::string>& platforms) {
    for (const std::string& platform : platforms) {
        const std::string hint = cache_hint(platform);
        if (!hint.empty()) return hint;
    }
    return "is the device's driver loaded, and may you open its files under /dev?";
}

std::vector<cl::Platform> find_platforms() {
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error& error) {
        if (error.err() != CL_PLATFORM_NOT_FOUND_KHR) throw_cl_error(error);
    }
    if (platforms.empty())
        throw Error(ExitCode::device, "no OpenCL platform", "",
                    "apt-get install pocl-opencl-icd (or your GPU's driver)");
    return platforms;
}

std::vector<Found> find_devices() {
    std::vector<Found> found;
    std::vector<std::string> names;
    for (const cl::Platform& platform : find_platforms()) {
        try {  // one broken driver must not hide the others
            names.push_back(trimmed(platform.getInfo<CL_PLATFORM_NAME>()));
            std::vector<cl::Device> devices;
            platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
            for (const cl::Device& device : devices) {
                if (!device.getInfo<CL_DEVICE_AVAILABLE>() ||
                    !device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>())
                    continue;
                DeviceInfo info = describe(device, names.back());
                info.number = static_cast<unsigned>(found.size());
                found.push_back({device, info});
            }
        } catch (const cl::Error&) {
        }
    }
    if (found.empty()) {
        std::string list;
        for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
        throw Error(ExitCode::device, "no OpenCL device (platforms: " + list + ")", "",
                    no_device_hint(names));
    }
    return found;
}

auto preference(const DeviceInfo& info) {
    // Units of different makers do not compare; a GPU with memory of its own comes first.
    const int kind = info.type & CL_DEVICE_TYPE_GPU           ? 3 - info.shares_host_memory
                     : info.type & CL_DEVICE_TYPE_ACCELERATOR ? 1
                                                              : 0;
    return std::make_tuple(kind, std::uint64_t{info.compute_units} * info.clock_mhz);
}

bool has_in_name(const DeviceInfo& info, const std::string& part) {
    return lower(info.name).find(part) != std::string::npos ||
           lower(info.platform).find(part) != std::string::npos;
}

}  // namespace

const char* device_type_name(cl_device_type type) {
    return type & CL_DEVICE_TYPE_GPU ? "GPU" : type & CL_DEVICE_TYPE_CPU ? "CPU" : "accelerator";
}

std::string cache_hint(const std::string& platform) {
    if (platform != "Portable Computing Language") return "";
    const char* folder = std::getenv("POCL_CACHE_DIR");
    return folder ? "PoCL does not work where its cache folder is not writable: POCL_CACHE_DIR=" +
                        std::string(folder)
                  : "PoCL does not work where its cache folder ($XDG_CACHE_HOME/pocl or "
                    "~/.cache/pocl) is not writable: set POCL_CACHE_DIR to a folder that is";
}

std::vector<DeviceInfo> list_devices() {
    std::vector<DeviceInfo> devices;
    for (const Found& found : find_devices()) devices.push_back(found.info);
    return devices;
}

std::size_t choose_device(const std::vector<DeviceInfo>& devices, const std::string& choice) {
    const bool digits =
        !choice.empty() && choice.find_first_not_of("0123456789") == std::string::npos;
    if (digits && choice.size() <= 4 && std::stoul(choice) < devices.size())
        return std::stoul(choice);
    const bool is_number = digits && choice.size() <= 2;  // "4090" may be a part of a name, not "4"
    std::size_t best = devices.size();
    for (std::size_t i = 0; i < devices.size(); ++i)
        if (!is_number && has_in_name(devices[i], lower(choice)) &&
            (best == devices.size() || preference(devices[best]) < preference(devices[i])))
            best = i;
    if (best < devices.size()) return best;
    std::string list;
    for (const DeviceInfo& info : devices)
        list += (list.empty() ? "there is " : ", ") + std::to_string(info.number) + " " +
                info.name + " (" + info.platform + ")";
    throw Error(ExitCode::device, "there is no device \"" + choice + "\"", "", list);
}

Device::Device(cl::Device device, DeviceInfo info)
    : info_(std::move(info)),
      device_(std::move(device)),
      context_(checked([&] { return cl::Context(device_); })),
      queue_(checked([&] { return cl::CommandQueue(context_, device_); })),
      memory_(std::make_shared<MemoryAccount>(info_.global_memory, info_.largest_allocation)) {}

void Device::finish() const {
    checked([&] { queue_.finish(); });
}

std::size_t chosen_device(const std::vector<DeviceInfo>& devices, const std::string& choice) {
    const char* variable = std::getenv("LOBE_DEVICE");
    if (!choice.empty() || !variable || !*variable) return choose_device(devices, choice);
    try {
        return choose_device(devices, variable);
    } catch (const Error& error) {
        throw Error(error.code(), error.what(), "LOBE_DEVICE", error.hint());
    }
}

Device open_device(const std::string& choice) {
    const std::vector<Found> found = find_devices();
    std::vector<DeviceInfo> devices;
    for (const Found& one : found) devices.push_back(one.info);
    const Found& one = found[chosen_device(devices, choice)];
    return Device(one.device, one.info);
}

}  // namespace lobe
