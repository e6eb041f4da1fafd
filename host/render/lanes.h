// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cl/device.h"

namespace lobe {

// How many samples of a pixel a work-item should take side by side: on CPUs vectors are made of
// what is written as vectors, on GPUs of work-items.
inline unsigned suitable_lanes(const DeviceInfo& info) {
    return info.type & CL_DEVICE_TYPE_CPU ? 8 : 1;
}

}  // namespace lobe
