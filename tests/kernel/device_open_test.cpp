// SPDX-License-Identifier: Apache-2.0
// Opening devices, and what is said where there is none. The loader reads the environment once a
// process, so these cases run in processes of their own.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "base/error.h"
#include "cl/device.h"
#include "support/device.h"
#include "support/temp_folder.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Opens the device with one more variable in the environment and exits as lobe would.
[[noreturn]] void open_with(const char* name, const std::string& value, const char* choice = "") {
    setenv(name, value.c_str(), 1);
    try {
        open_device(choice);
    } catch (const Error& error) {
        std::cerr << error.message() << std::endl;
        std::_Exit(static_cast<int>(error.code()));
    }
    std::_Exit(0);
}

}  // namespace

TEST(OpenDeviceDeathTest, NoPlatform) {
    EXPECT_EXIT(open_with("OCL_ICD_VENDORS", "/nonexistent"), testing::ExitedWithCode(4),
                "no OpenCL platform\n.*hint: apt-get install pocl-opencl-icd");
}

TEST(OpenDeviceDeathTest, PoclWithoutItsCacheFolder) {
    const std::string pocl = "/etc/OpenCL/vendors/pocl.icd";
    if (!std::filesystem::exists(pocl)) GTEST_SKIP() << "no PoCL";
    const ScopedVariable only("OCL_ICD_VENDORS", pocl.c_str());
    EXPECT_EXIT(open_with("POCL_CACHE_DIR", "/dev/null/cache"), testing::ExitedWithCode(4),
                "no OpenCL device.*\n.*POCL_CACHE_DIR=/dev/null/cache");
}

TEST(OpenDeviceDeathTest, TheVariableChooses) {
    EXPECT_EXIT(open_with("LOBE_DEVICE", "no such thing"), testing::ExitedWithCode(4),
                "LOBE_DEVICE: there is no device \"no such thing\"\n.*there is 0 ");
    EXPECT_EXIT(open_with("LOBE_DEVICE", "0"), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(open_with("LOBE_DEVICE", "no such thing", "0"), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(open_with("LOBE_DEVICE", ""), testing::ExitedWithCode(0), "");
}

TEST(ListDevices, TellsWhatReportsNeed) {
    const std::vector<DeviceInfo> devices = list_devices();
    ASSERT_FALSE(devices.empty());
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const DeviceInfo& info = devices[i];
        EXPECT_EQ(info.number, i);
        for (const std::string& text :
             {info.name, info.platform, info.vendor, info.driver, info.version, info.opencl_c}) {
            EXPECT_FALSE(text.empty());
            EXPECT_EQ(text.find('\0'), std::string::npos) << text;
        }
        EXPECT_GT(info.compute_units, 0u);
        EXPECT_GE(info.largest_allocation, info.global_memory / 4);  // OpenCL 1.2, table 4.3
        EXPECT_LE(info.largest_allocation, info.global_memory);
    }
}

TEST(Device, CanBeMoved) {
    Device first = open_device(std::to_string(test_device().info().number));
    const Device second = std::move(first);
    EXPECT_EQ(second.info().name, test_device().info().name);
    EXPECT_NE(second.queue()(), nullptr);
    second.finish();
}
