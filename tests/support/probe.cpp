// SPDX-License-Identifier: Apache-2.0
#include "support/probe.h"

#include <algorithm>

#include "base/kernel_text.h"

namespace lobe::test {

std::vector<std::string> all_features() {
    return {
#define LOBE_FEATURE(name, meaning) #name,
#include "shared/features.def"
#undef LOBE_FEATURE
    };
}

// A model is a file NAME.h that has a table of NAME_parameters.
std::vector<std::string> all_brdfs() {
    const KernelText kernels;
    std::vector<std::string> names;
    for (const std::string& path : kernels.list("brdf/")) {
        const std::string name = path.substr(5, path.find('.') - 5);
        if (kernels.read(path).find("#define " + name + "_parameters(") != std::string::npos)
            names.push_back(name);
    }
    return names;
}

std::string scene_text(const std::vector<std::string>& features,
                       const std::vector<std::string>& brdfs) {
    std::string text;
    for (const std::string& name : all_features()) {
        const bool has = std::count(features.begin(), features.end(), name) > 0;
        text += "#define LOBE_HAS_" + name + (has ? " 1\n" : " 0\n");
    }
    std::string list;
    for (const std::string& name : brdfs) {
        text += "#include \"brdf/" + name + ".h\"\n";
        list += " X(" + name + ")";
    }
    return text + "#define LOBE_BRDFS(X)" + list + "\n";
}

Program build_probe(const std::string& path, Texts texts, const ProgramOptions& options) {
    texts.emplace("lobe_scene.h", scene_text());
    return build_program(test_device(), flatten(KernelText(), path, texts), options);
}

}  // namespace lobe::test
