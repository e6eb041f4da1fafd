// SPDX-License-Identifier: Apache-2.0
// Command lines that make no sense, told so that the next one does.
#pragma once

#include <CLI/CLI.hpp>

#include "base/error.h"

namespace lobe {

// What was wrong with the command line, with the nearest option or verb and the help to look at.
Error usage_error(const CLI::App& app, const CLI::ParseError& fault);

}  // namespace lobe
