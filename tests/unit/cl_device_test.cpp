// SPDX-License-Identifier: Apache-2.0
// Choosing a device from lists, without a device.
#include "cl/device.h"

#include <gtest/gtest.h>

#include "base/error.h"

using namespace lobe;

namespace {

DeviceInfo device(unsigned number, const char* name, const char* platform, cl_device_type type,
                  unsigned units, unsigned clock) {
    DeviceInfo info;
    info.number = number;
    info.name = name;
    info.platform = platform;
    info.type = type;
    info.compute_units = units;
    info.clock_mhz = clock;
    return info;
}

const std::vector<DeviceInfo> devices = {
    device(0, "cpu-EPYC", "Portable Computing Language", CL_DEVICE_TYPE_CPU, 128, 3000),
    device(1, "GeForce RTX 4090", "NVIDIA CUDA", CL_DEVICE_TYPE_GPU, 128, 2500),
    device(2, "NVIDIA H200", "NVIDIA CUDA", CL_DEVICE_TYPE_GPU, 132, 2600),
    device(3, "FPGA", "Intel", CL_DEVICE_TYPE_ACCELERATOR, 1, 300),
};

}  // namespace

TEST(ChooseDevice, ByNumberNameAndPlatform) {
    EXPECT_EQ(choose_device(devices, "0"), 0u);
    EXPECT_EQ(choose_device(devices, "3"), 3u);
    EXPECT_EQ(choose_device(devices, "epyc"), 0u);
    EXPECT_EQ(choose_device(devices, "PORTABLE"), 0u);
    EXPECT_EQ(choose_device(devices, "4090"), 1u);  // no such number, but a part of a name
}

TEST(ChooseDevice, AmbiguousNamesGiveTheFastest) {
    EXPECT_EQ(choose_device(devices, "nvidia"), 2u);
    EXPECT_EQ(choose_device(devices, ""), 2u);
    EXPECT_EQ(choose_device({devices[0], devices[3]}, ""), 1u);  // accelerator before CPU
    EXPECT_EQ(choose_device({devices[1], devices[1]}, ""), 0u);  // the first of equals
}

TEST(ChooseDevice, AStrangerIsRefusedWithTheList) {
    for (const char* choice : {"4", "999999999999", "-1", "radeon"}) {
        try {
            choose_device(devices, choice);
            FAIL() << choice;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::device);
            EXPECT_NE(error.message().find(choice), std::string::npos);
            EXPECT_NE(error.hint().find("2 NVIDIA H200 (NVIDIA CUDA)"), std::string::npos);
        }
    }
}
