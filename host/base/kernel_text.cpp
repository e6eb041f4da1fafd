// SPDX-License-Identifier: Apache-2.0
#include "base/kernel_text.h"

#include <algorithm>
#include <filesystem>

#include "base/embedded.h"
#include "base/error.h"
#include "base/files.h"

namespace lobe {

namespace fs = std::filesystem;

namespace {

const char* embedded_text(const std::string& path) {
    for (std::size_t i = 0; i < embedded_file_count; ++i)
        if (path == embedded_files[i].path) return embedded_files[i].text;
    return nullptr;
}

// Kernel files are named from the root of the kernels and stay below it.
bool stays_inside(const fs::path& path) {
    return !path.empty() && path.is_relative() &&
           std::find(path.begin(), path.end(), "..") == path.end();
}

}  // namespace

KernelText::KernelText(std::string folder) : folder_(std::move(folder)) {
    if (folder_.empty()) return;
    std::error_code error;
    fs::directory_iterator(folder_, error);
    if (error)
        throw Error(ExitCode::device, "the folder of kernels cannot be read: " + error.message(),
                    folder_, "give --kernel-dir a copy of lobe's kernels/ folder");
}

bool KernelText::has(const std::string& path) const { return added(path) || has_file(path); }

bool KernelText::has_file(const std::string& path) const {
    if (folder_.empty()) return embedded_text(path) != nullptr;
    std::error_code error;
    return stays_inside(path) && fs::is_regular_file(fs::path(folder_) / path, error);
}

std::string KernelText::read(const std::string& path) const {
    if (added(path)) return added_.at(path);
    if (!has_file(path)) throw Error(ExitCode::device, "there is no kernel file \"" + path + "\"");
    if (folder_.empty()) return embedded_text(path);
    return read_file((fs::path(folder_) / path).string(), ExitCode::device);
}

std::vector<std::string> KernelText::list(const std::string& prefix) const {
    std::vector<std::string> paths;
    const auto take = [&](const std::string& path) {
        if (path.compare(0, prefix.size(), prefix) == 0) paths.push_back(path);
    };
    if (folder_.empty()) {
        for (std::size_t i = 0; i < embedded_file_count; ++i) take(embedded_files[i].path);
    } else {
        for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
            const std::string extension = entry.path().extension().string();
            if (entry.is_regular_file() &&
                (extension == ".h" || extension == ".cl" || extension == ".def"))
                take(fs::relative(entry.path(), folder_).generic_string());
        }
    }
    for (const auto& row : added_) take(row.first);
    std::sort(paths.begin(), paths.end());
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    return paths;
}

}  // namespace lobe
