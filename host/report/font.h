// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lobe {

// A plain sans-serif font file: DejaVu Sans where it is installed, else another that is known to
// have Greek letters; from the fonts folders of XDG_DATA_HOME and XDG_DATA_DIRS. Empty if there is
// none.
std::string find_font();

}  // namespace lobe
