// SPDX-License-Identifier: Apache-2.0
#include "support/probe.h"

#include "base/kernel_text.h"
#include "build/features.h"

namespace lobe::test {

// A model is a file NAME.h that has a table of NAME_parameters.
std::vector<std::string> all_models() {
    const KernelText kernels;
    std::vector<std::string> names;
    for (const std::string& path : kernels.list("brdf/")) {
        const std::string name = path.substr(5, path.find('.') - 5);
        if (kernels.read(path).find("#define " + name + "_parameters(") != std::string::npos)
            names.push_back(name);
    }
    return names;
}

std::string general_scene_text() { return scene_header(all_features(), all_models()); }

Program build_probe(const std::string& path, Texts texts, const ProgramOptions& options) {
    texts.emplace("lobe_scene.h", general_scene_text());
    return build_program(test_device(), flatten(KernelText(), path, texts), options);
}

}  // namespace lobe::test
