// SPDX-License-Identifier: Apache-2.0
#include "support/probe.h"

#include <cstdlib>

#include "base/kernel_text.h"
#include "build/features.h"
#include "scene/brdf_table.h"

namespace lobe::test {

KernelText test_kernels() {
    const char* const folder = std::getenv("LOBE_TEST_KERNELS");
    return KernelText(folder ? folder : "");
}

std::string general_scene_text() {
    return scene_header(all_features(), read_brdf_tables(test_kernels()));
}

Program build_probe(const std::string& path, Texts texts, const ProgramOptions& options) {
    texts.emplace("lobe_scene.h", general_scene_text());
    return build_program(test_device(), flatten(test_kernels(), path, texts), options);
}

}  // namespace lobe::test
