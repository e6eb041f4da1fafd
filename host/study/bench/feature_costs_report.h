// SPDX-License-Identifier: Apache-2.0
// The figures of `lobe features --measure` as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "study/bench/feature_costs.h"

namespace lobe {

std::string to_text(const FeatureCosts& costs, const DeviceInfo& device, const CostPlan& plan);
nlohmann::ordered_json to_json(const FeatureCosts& costs, const DeviceInfo& device,
                               const CostPlan& plan);

}  // namespace lobe
