// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lobe {

// RFC 4648, with padding.
std::string base64(const std::string& bytes);

// "data:TYPE;base64,...": a file within a page.
std::string data_uri(const std::string& type, const std::string& bytes);

}  // namespace lobe
