// SPDX-License-Identifier: Apache-2.0
// Files of measured reflectance: MERL's binary layout and lobe's text (tools/docs/measured.md).
#pragma once

#include <string>

#include "scene/measured.h"

namespace lobe {

// Reads a file of either layout, whichever it is. Cells of negative values have no data. Throws
// Error (scene) with the file and, for text, line and column.
MeasuredBrdf read_measured(const std::string& path);

// Writes MERL's layout: values become doubles, missing ones -1. Throws Error (output).
void write_merl(const std::string& path, const MeasuredBrdf& table);

// Writes lobe's text layout in nine digits, which read back the same floats. Throws Error (output).
void write_measured_text(const std::string& path, const MeasuredBrdf& table);

}  // namespace lobe
