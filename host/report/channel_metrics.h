// SPDX-License-Identifier: Apache-2.0
// The figures of one channel.
#pragma once

#include <string>

#include "report/metrics.h"

namespace lobe {

// Of at least one pixel. `trimmed` pixels are dropped from the trimmed figures.
ChannelMetrics measure_channel(const std::string& name, const ChannelPair& pair,
                               std::uint32_t block, std::size_t trimmed);

}  // namespace lobe
