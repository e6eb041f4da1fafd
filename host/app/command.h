// SPDX-License-Identifier: Apache-2.0
// The verbs of the command line. Each adds itself to the parser and returns what runs it.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "base/kernel_text.h"

namespace lobe {

// Options that every verb has, under the same names.
struct CommonOptions {
    std::string device, kernel_folder, json;
    bool quiet = false;
};
void add_common_options(CLI::App& verb, CommonOptions& options);

// The kernels in the program, or those of --kernel-dir. Throws Error (device) for a folder without.
KernelText open_kernels(const CommonOptions& options);

// The exit code of the run.
using Command = std::function<int()>;

Command add_render_command(CLI::App& app, const std::vector<std::string>& command_line);
Command add_devices_command(CLI::App& app);
Command add_compare_command(CLI::App& app, const std::vector<std::string>& command_line);
Command add_bench_command(CLI::App& app, const std::vector<std::string>& command_line);
Command add_converge_command(CLI::App& app, const std::vector<std::string>& command_line);
Command add_features_command(CLI::App& app);
Command add_brdf_command(CLI::App& app);
Command add_diff_command(CLI::App& app);
Command add_paper_command(CLI::App& app, const std::vector<std::string>& command_line);

// Writes JSON text to a file, or to standard output for "-".
void write_json(const std::string& where, const std::string& text);

}  // namespace lobe
