// SPDX-License-Identifier: Apache-2.0
#include "cl/program.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "base/error.h"
#include "base/files.h"
#include "base/sha256.h"
#include "base/timer.h"
#include "cl/binary_cache.h"
#include "cl/build_log.h"
#include "cl/cl_error.h"
#include "cl/device.h"

namespace lobe {

namespace {

std::string build_options(const DeviceInfo& info) {
    std::string options = "-cl-std=CL1.2";
    if (info.correctly_rounded) options += " -cl-fp32-correctly-rounded-divide-sqrt";
    return options;
}

std::string complete_text(const std::string& source, const ProgramOptions& options) {
    std::string text = "#pragma OPENCL FP_CONTRACT OFF\n";
    if (options.double_precision) text += "#define LOBE_DOUBLE 1\n";
    return text + source;
}

// Keeps the text and the log of a failed build in the cache folder, or else in a new one of the
// system's; gives the file's name, or "" if none can be written.
std::string keep_evidence(const std::string& text, const std::string& options,
                          const std::string& log, const std::string& key) {
    std::string content = "// lobe: this text does not build with " + options + "\n";
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) content += "// " + line + "\n";
    content += text;
    const auto write_in = [&](const std::string& folder) {
        const std::string path = folder + "/failed-" + key.substr(0, 12) + ".cl";
        write_file(path, content);
        return path;
    };
    try {
        std::filesystem::create_directories(cache_folder());
        return write_in(cache_folder());
    } catch (const std::exception&) {
    }
    try {  // a name that nobody could have put something at
        std::string folder = (std::filesystem::temp_directory_path() / "lobe-XXXXXX").string();
        return mkdtemp(&folder[0]) ? write_in(folder) : "";
    } catch (const std::exception&) {
        return "";
    }
}

[[noreturn]] void throw_build_error(const cl::Error& error, const Program& program,
                                    const Device& device, const std::string& text,
                                    const std::string& options) {
    std::string log;
    try {
        log = program.program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device.device());
    } catch (const cl::Error&) {
    }
    BuildFault fault = first_fault(log, text);
    const bool silent = fault.what.empty();
    if (silent)
        fault.what = std::string(cl_error_name(error.err())) + " (" + std::to_string(error.err()) +
                     ") from " + error.what();
    std::string hint = silent ? cache_hint(device.info().platform) : "";
    const std::string evidence = keep_evidence(text, options, log, program.key);
    if (hint.empty() && !evidence.empty())
        hint = "its text and the compiler's log are in " + evidence;
    throw Error(ExitCode::device, "the kernel does not build: " + fault.what, fault.where, hint);
}

}  // namespace

cl::Kernel Program::kernel(const std::string& name) const {
    return checked([&] { return cl::Kernel(program, name.c_str()); });
}

std::optional<std::size_t> binary_bytes(const Program& program) {
    try {
        const auto sizes = program.program.getInfo<CL_PROGRAM_BINARY_SIZES>();
        if (sizes.size() == 1 && sizes[0] > 0) return sizes[0];
    } catch (const cl::Error&) {
    }
    return {};
}

// All that a binary depends on, with lengths so that no two lists of parts read alike.
std::string program_key(const DeviceInfo& info, const std::string& source,
                        const ProgramOptions& options) {
    Sha256 sum;
    for (const std::string& part :
         {complete_text(source, options), build_options(info), info.platform, info.name,
          info.vendor, info.version, info.driver})
        sum.add(std::to_string(part.size()) + ":" + part);
    return sum.hex();
}

Program build_program(const Device& device, const std::string& source,
                      const ProgramOptions& options) {
    const DeviceInfo& info = device.info();
    if (options.double_precision && !info.fp64)
        throw Error(ExitCode::device, "the device " + info.name + " has no double precision");
    const Stopwatch watch;
    const std::string text = complete_text(source, options);
    const std::string flags = build_options(info);
    Program program;
    program.key = program_key(info, source, options);
    program.cached = load_binary(device, program, flags);
    if (!program.cached) {
        program.program = checked([&] { return cl::Program(device.context(), text); });
        try {
            program.program.build({device.device()}, flags.c_str());
        } catch (const cl::Error& error) {
            throw_build_error(error, program, device, text, flags);
        }
        program.log = checked(
            [&] { return program.program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device.device()); });
    }
    program.build_seconds = watch.seconds();
    return program;
}

}  // namespace lobe
