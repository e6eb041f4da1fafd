// SPDX-License-Identifier: Apache-2.0
// What compilers say of a text that does not build.
#pragma once

#include <string>

namespace lobe {

// {"core/real.h:5:40", "unknown type name 'rael'"}; empty where the log does not tell.
struct BuildFault {
    std::string where, what;
};

// The first error of a build log. Compilers that pay no heed to `#line` name a line of the whole
// text: it is found again by the markers that flatten() put there.
BuildFault first_fault(const std::string& log, const std::string& text);

}  // namespace lobe
