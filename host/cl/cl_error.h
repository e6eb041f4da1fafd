// SPDX-License-Identifier: Apache-2.0
// OpenCL's error codes as lobe's errors.
#pragma once

#include <CL/opencl.hpp>
#include <string>
#include <utility>

namespace lobe {

// "CL_OUT_OF_RESOURCES" for -5; "unknown code" for a code that the standard does not know.
const char* cl_error_name(cl_int code);

// Throws Error (device) "CALL failed: NAME (CODE)", with a hint for the codes that have one.
[[noreturn]] void throw_cl_error(const cl::Error& error);

// The result of work(), with every cl::Error it throws made an Error (device).
template <typename Work>
auto checked(Work&& work) -> decltype(work()) {
    try {
        return std::forward<Work>(work)();
    } catch (const cl::Error& error) {
        throw_cl_error(error);
    }
}

}  // namespace lobe
