// SPDX-License-Identifier: Apache-2.0
// What lobe says on standard error beside errors. Results go to standard output, never here.
#pragma once

#include <string>

namespace lobe {

// With --quiet, notes and progress are not written; warnings and errors are.
void set_quiet(bool quiet);
bool is_quiet();

// "lobe: warning: WHERE: TEXT" (where may be empty).
void warn(const std::string& text, const std::string& where = "");

// "lobe: TEXT"; not with --quiet.
void note(const std::string& text);

// A line that stays at the bottom of the terminal while other lines pass above it; "" removes it.
void show_live_line(const std::string& line);

}  // namespace lobe
