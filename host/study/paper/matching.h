// SPDX-License-Identifier: Apache-2.0
// The models' lobes measured on the device: albedos, and the n of equal half-width.
#pragma once

#include "cl/device.h"
#include "study/paper/setting.h"

namespace lobe {

// Programs are compiled at the first question about a model, answers kept. In double where the
// device can, for they are of the model and not of rounding. Both must outlive the result.
LobeMeasure measured_on(const Device& device, const KernelText& kernels);

}  // namespace lobe
