// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lobe {

// The text, a line, as SVG and HTML want it between tags and in quoted attributes: & < > " '
// escaped, what is not printable (base/error.h) shown as \xNN.
std::string markup_text(const std::string& text);

}  // namespace lobe
