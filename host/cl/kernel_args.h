// SPDX-License-Identifier: Apache-2.0
// Calling a kernel: its arguments in order, and a launch.
#pragma once

#include <CL/opencl.hpp>
#include <string>

#include "base/error.h"
#include "cl/buffer.h"
#include "cl/cl_error.h"

namespace lobe {

template <typename T>
void set_arg(cl::Kernel& kernel, cl_uint index, const Buffer<T>& buffer) {
    kernel.setArg(index, buffer.get());
}
template <typename T>
void set_arg(cl::Kernel& kernel, cl_uint index, const T& value) {
    kernel.setArg(index, value);
}

// Sets all arguments: buffers, shared structs and scalars of the exact type that the kernel has.
// Throws Error (device) that names the kernel and the argument, counted from 0.
template <typename... Args>
void set_args(cl::Kernel& kernel, const Args&... args) {
    cl_uint index = 0;
    try {
        const auto count = kernel.getInfo<CL_KERNEL_NUM_ARGS>();
        if (count != sizeof...(args))
            throw Error(ExitCode::internal, "kernel " + kernel.getInfo<CL_KERNEL_FUNCTION_NAME>() +
                                                " has " + std::to_string(count) +
                                                " arguments, not " +
                                                std::to_string(sizeof...(args)));
        ((set_arg(kernel, index, args), ++index), ...);
    } catch (const cl::Error& error) {
        throw Error(ExitCode::device, "argument " + std::to_string(index) + " of kernel " +
                                          kernel.getInfo<CL_KERNEL_FUNCTION_NAME>() + ": " +
                                          cl_error_name(error.err()));
    }
}

// Enqueues the kernel over `global` work-items in groups of `local` and gives its event. Every
// dimension of global must be a multiple of local's.
inline cl::Event launch(const Device& device, const cl::Kernel& kernel, const cl::NDRange& global,
                        const cl::NDRange& local = cl::NullRange) {
    return checked([&] {
        cl::Event event;
        device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, global, local, nullptr, &event);
        return event;
    });
}

}  // namespace lobe
