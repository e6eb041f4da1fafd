// SPDX-License-Identifier: Apache-2.0
// What a trial does with a model; trial.h starts it.
#pragma once

#include <functional>
#include <string>

#include "scene/brdf_table.h"

namespace lobe {

class Device;
class KernelText;

// Builds the model's program and calls its functions. `step` is told before each call that may not
// come back: "the build", "velvet_eval". Throws Error as try_model does.
void run_trial(const Device& device, const KernelText& kernels, const BrdfTable& model,
               const std::function<void(const std::string&)>& step);

}  // namespace lobe
