// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/drawing.h"

namespace lobe {

// The drawing as an SVG file that needs nothing beside it: no script, no style sheet, no font.
std::string to_svg(const Drawing& drawing);

}  // namespace lobe
