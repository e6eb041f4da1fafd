// SPDX-License-Identifier: Apache-2.0
// Test kernels of kernels/probe/, built as the renderer is built.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/kernel_text.h"
#include "cl/kernel_args.h"
#include "cl/program.h"
#include "cl/source.h"
#include "support/device.h"

namespace lobe::test {

// The kernels under test: those of the program, or of the folder that LOBE_TEST_KERNELS names, so
// that planted errors can be seen to fail.
KernelText test_kernels();

using Texts = std::map<std::string, std::string>;

// The text of lobe_scene.h for the general kernel: all features, all models.
std::string general_scene_text();

// Flattens a kernel file (or the text `texts[path]`) and builds it for test_device(). Where `texts`
// has no "lobe_scene.h", the general one is taken.
Program build_probe(const std::string& path, Texts texts = {}, const ProgramOptions& options = {});

// Runs a kernel once over `count` work-items and waits.
template <typename... Args>
void run_probe(const Program& program, const std::string& name, std::size_t count,
               const Args&... args) {
    cl::Kernel kernel = program.kernel(name);
    set_args(kernel, args...);
    launch(test_device(), kernel, cl::NDRange(count));
    test_device().finish();
}

}  // namespace lobe::test
