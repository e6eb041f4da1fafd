// SPDX-License-Identifier: Apache-2.0
// The main function of every test program. It owns the device, so that no OpenCL object outlives
// it.
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/device.h"
#include "support/temp_folder.h"

int main(int count, char** arguments) {
    testing::InitGoogleTest(&count, arguments);
    testing::FLAGS_gtest_death_test_style = "threadsafe";  // a forked OpenCL is no OpenCL
    const lobe::test::TempFolder cache;
    setenv("LOBE_CACHE_DIR", cache.path().c_str(), 0);  // tests leave the user's own alone
    testing::AddGlobalTestEnvironment(new lobe::test::TestDevice);
    return RUN_ALL_TESTS();
}
