// SPDX-License-Identifier: Apache-2.0
#include "cl/binary_cache.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "base/sha256.h"
#include "cl/device.h"
#include "cl/program.h"

namespace lobe {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_files = 64;  // older ones are removed

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::string file_of(const Program& program) { return cache_folder() + "/" + program.key + ".bin"; }

// What stands before the binary: who wrote it, the program's key, the binary's bytes and hash.
std::string header(const std::string& key, const std::string& binary) {
    return "lobe binary 1\n" + key + "\n" + std::to_string(binary.size()) + "\n" + sha256(binary) +
           "\n";
}

// The binary in a file's content, or "" if anything about it is wrong.
std::string checked_payload(const std::string& content, const std::string& key) {
    std::size_t begin = 0;
    for (int line = 0; line < 4; ++line) {
        begin = content.find('\n', begin);
        if (begin == std::string::npos) return "";
        ++begin;
    }
    const std::string binary = content.substr(begin);
    return content.compare(0, begin, header(key, binary)) == 0 ? binary : "";
}

void remove_old_files() {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (const auto& entry : fs::directory_iterator(cache_folder()))
        if (entry.path().extension() == ".bin")
            files.emplace_back(entry.last_write_time(), entry.path());
    if (files.size() <= most_files) return;
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i < files.size() - most_files; ++i) fs::remove(files[i].second);
}

}  // namespace

std::string cache_folder() {
    if (!variable("LOBE_CACHE_DIR").empty()) return variable("LOBE_CACHE_DIR");
    if (!variable("XDG_CACHE_HOME").empty()) return variable("XDG_CACHE_HOME") + "/lobe";
    if (!variable("HOME").empty()) return variable("HOME") + "/.cache/lobe";
    return "";
}

bool binary_cache_pays(const DeviceInfo& info) {
    const std::string wish = variable("LOBE_PROGRAM_CACHE");
    if (wish == "on") return true;
    if (wish == "off") return false;
    // PoCL has a cache of its own. With ours a second start of the general kernel took 0.015 s in
    // place of 0.06-0.09 s, but asking for the binary cost the first run 0.75 s.
    return info.platform != "Portable Computing Language";
}

bool load_binary(const Device& device, Program& program, const std::string& build_options) {
    if (cache_folder().empty() || !binary_cache_pays(device.info())) return false;
    const std::string path = file_of(program);
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return false;
    try {
        const std::string binary = checked_payload(read_file(path, ExitCode::device), program.key);
        if (!binary.empty()) {
            const cl::Program::Binaries binaries{{binary.begin(), binary.end()}};
            program.program = cl::Program(device.context(), {device.device()}, binaries);
            program.program.build({device.device()}, build_options.c_str());
            return true;
        }
    } catch (const std::exception&) {  // unreadable, or refused by the driver
    }
    fs::remove(path, error);
    return false;
}

void save_binary(const Device& device, const Program& program) {
    if (program.cached || cache_folder().empty() || !binary_cache_pays(device.info())) return;
    try {
        const auto binaries = program.program.getInfo<CL_PROGRAM_BINARIES>();
        if (binaries.size() != 1 || binaries[0].empty()) return;
        const std::string binary(binaries[0].begin(), binaries[0].end());
        fs::create_directories(cache_folder());
        write_file(file_of(program), header(program.key, binary) + binary);
        remove_old_files();
    } catch (const std::exception&) {
    }
}

}  // namespace lobe
