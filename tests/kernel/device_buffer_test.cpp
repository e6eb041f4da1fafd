// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numeric>

#include "base/error.h"
#include "cl/buffer.h"
#include "support/device.h"

using namespace lobe;
using namespace lobe::test;

TEST(Buffer, CarriesDataThereAndBack) {
    std::vector<int> data(1000);
    std::iota(data.begin(), data.end(), -500);
    Buffer<int> buffer(test_device(), data);
    EXPECT_EQ(buffer.count(), 1000u);
    EXPECT_EQ(buffer.bytes(), 4000u);
    EXPECT_EQ(buffer.read_all(), data);
    int part[3];
    buffer.read(part, 3, 997);
    EXPECT_EQ(part[0], 497);
    EXPECT_EQ(part[2], 499);
    const int news[2] = {7, 8};
    buffer.write(news, 2, 10);
    buffer.read(part, 3, 9);
    EXPECT_EQ(part[0], -491);
    EXPECT_EQ(part[1], 7);
    EXPECT_EQ(part[2], 8);
    buffer.fill_zero();
    EXPECT_EQ(buffer.read_all(), std::vector<int>(1000, 0));
}

TEST(Buffer, EmptyVectorsHaveAPlace) {
    const Buffer<float> buffer(test_device(), std::vector<float>{});
    EXPECT_EQ(buffer.count(), 0u);
    EXPECT_EQ(buffer.bytes(), 4u);
    EXPECT_NE(buffer.get()(), nullptr);
    EXPECT_TRUE(buffer.read_all().empty());
}

TEST(Buffer, IsAccountedForWhileItLives) {
    const MemoryAccount& account = *test_device().memory();
    const auto before = account.used();
    {
        Buffer<float> one(test_device(), 1000);
        EXPECT_EQ(account.used(), before + 4000);
        Buffer<float> two = std::move(one);
        EXPECT_EQ(account.used(), before + 4000);
        two = Buffer<float>(test_device(), 10);
        EXPECT_EQ(account.used(), before + 40);
    }
    EXPECT_EQ(account.used(), before);
}

TEST(Buffer, TooMuchIsRefusedWithFigures) {
    const auto before = test_device().memory()->used();
    const std::size_t count = test_device().info().largest_allocation / sizeof(double) + 1;
    try {
        Buffer<double>(test_device(), count, "the film");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::device);
        EXPECT_EQ(std::string(error.what()).find("the film needs "), 0u) << error.what();
    }
    EXPECT_EQ(test_device().memory()->used(), before);
}

// PoCL would promise any number of these.
TEST(Buffer, ManyAreRefusedBeforeTheDeviceIsFull) {
    const DeviceInfo& info = test_device().info();
    std::vector<Buffer<char>> buffers;
    const std::size_t most = info.global_memory / info.largest_allocation + 1;
    EXPECT_THROW(for (std::size_t i = 0; i < most; ++i)
                     buffers.emplace_back(test_device(), info.largest_allocation),
                 Error);
    EXPECT_LT(buffers.size(), most);
}
