// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"

#include <cstdio>

#include "base/error.h"
#include "base/files.h"

namespace lobe {

void add_common_options(CLI::App& verb, CommonOptions& options) {
    verb.add_option("--device", options.device, "number or part of the name (see `lobe devices`)")
        ->type_name("NUMBER|NAME");
    verb.add_option("--kernel-dir", options.kernel_folder, "take the kernels from this folder")
        ->type_name("DIR");
    verb.add_option("--json", options.json, "write the results as JSON; - is standard output")
        ->type_name("FILE");
    verb.add_flag("--quiet", options.quiet, "no progress, no notes, no summary");
}

KernelText open_kernels(const CommonOptions& options) {
    KernelText kernels(options.kernel_folder);
    if (!kernels.has("render.cl"))
        throw Error(ExitCode::device, "the folder holds no kernels", options.kernel_folder,
                    "give --kernel-dir a copy of lobe's kernels/ folder");
    return kernels;
}

void write_json(const std::string& where, const std::string& text) {
    if (where == "-") {
        std::fwrite(text.data(), 1, text.size(), stdout);
        return;
    }
    write_file(where, text);
}

}  // namespace lobe
