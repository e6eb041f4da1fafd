// SPDX-License-Identifier: Apache-2.0
// From one kernel text to kernels that can be called.
#pragma once

#include <CL/opencl.hpp>
#include <optional>
#include <string>

namespace lobe {

class Device;
struct DeviceInfo;

struct ProgramOptions {
    bool double_precision = false;  // `real` is double: for tests and oracles
};

struct Program {
    cl::Program program;
    double build_seconds = 0;
    bool cached = false;  // taken from lobe's cache of binaries
    std::string key;      // SHA-256 of all that the binary depends on
    std::string log;      // what the compiler said: warnings

    // Throws Error (device) if the program has no such kernel.
    cl::Kernel kernel(const std::string& name) const;
};

// Bytes of the program's binary, or nothing if the device does not tell. Asking may cost a
// compilation.
std::optional<std::size_t> binary_bytes(const Program& program);

// The key of the program that build_program makes of this text.
std::string program_key(const DeviceInfo& info, const std::string& source,
                        const ProgramOptions& options = {});

// Builds the text (see flatten) for the device, or takes the binary of an earlier run. Options
// never weaken the arithmetic. Throws Error (device) at the FILE:LINE:COL of the first error; its
// hint names a file that holds the text and the whole log.
Program build_program(const Device& device, const std::string& source,
                      const ProgramOptions& options = {});

}  // namespace lobe
