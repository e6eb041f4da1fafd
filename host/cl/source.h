// SPDX-License-Identifier: Apache-2.0
// One kernel text out of many files.
#pragma once

#include <map>
#include <string>

namespace lobe {

class KernelText;

// The file `path` of the kernels with every `#include "x"` replaced by the file x, named from the
// kernels' root. Texts in `generated` ("lobe_scene.h") take precedence over files. A text that was
// added to the kernels may also include files that lie beside it, and they theirs; a kernel's name
// wins. Headers come once, .def tables every time; `#line` keeps build messages pointing at the
// file and line that a person can edit. Throws Error with FILE:LINE:COL for a missing file: device,
// or scene where a user's own file asks for it.
std::string flatten(const KernelText& kernels, const std::string& path,
                    const std::map<std::string, std::string>& generated = {});

}  // namespace lobe
