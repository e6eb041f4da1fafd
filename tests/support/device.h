// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "cl/device.h"

namespace lobe::test {

// Keeps the process's one device between its first use and the end of the tests.
class TestDevice : public testing::Environment {
  public:
    void TearDown() override;
};

// The device under test: LOBE_DEVICE, else the fastest. Opened at the first call.
const Device& test_device();

}  // namespace lobe::test

// Leaves the running test, by name, on a device without cl_khr_fp64.
#define LOBE_NEEDS_DOUBLE()                     \
    if (!lobe::test::test_device().info().fp64) \
    GTEST_SKIP() << "the device has no cl_khr_fp64: " << lobe::test::test_device().info().name
