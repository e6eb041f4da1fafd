// SPDX-License-Identifier: Apache-2.0
// One kernel text out of many files.
#pragma once

#include <map>
#include <string>

namespace lobe {

class KernelText;

// The file `path` of the kernels with every `#include "x"` replaced by the file x, named from the
// kernels' root. Texts in `generated` ("lobe_scene.h", a user's "brdf/velvet.cl") take precedence
// over files. Headers come once, .def tables every time; `#line` keeps build messages pointing at
// the file and line that a person can edit. Throws Error (device) with FILE:LINE for a missing
// file.
std::string flatten(const KernelText& kernels, const std::string& path,
                    const std::map<std::string, std::string>& generated = {});

}  // namespace lobe
