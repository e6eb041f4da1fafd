// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "build/pack.h"

namespace lobe {

// Throws Error (internal) if the scene holds what its features leave out: looked up in the arrays
// themselves, so that a feature forgotten is an error and not another picture.
void check_features(const PackedScene& packed);

}  // namespace lobe
