// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "base/tail_index.h"
#include "report/estimate.h"

namespace lobe {

// The tail of the pixels' errors, each in units of its surroundings' typical error, so that a
// picture with noisy and quiet parts is not taken for one with rare bright samples. If it is heavy
// the picture holds samples so rare and bright that its error bars cannot be trusted, and those of
// a longer render may be larger. Nothing for pictures too small to tell or without error bars.
std::optional<TailIndex> error_tail(const Estimate& picture);

}  // namespace lobe
