// SPDX-License-Identifier: Apache-2.0
#include "support/device.h"

namespace lobe::test {

namespace {
std::unique_ptr<Device> device;
}

void TestDevice::TearDown() { device.reset(); }

const Device& test_device() {
    if (!device) device = std::make_unique<Device>(open_device());
    return *device;
}

}  // namespace lobe::test
