// SPDX-License-Identifier: Apache-2.0
#include "cl/memory.h"

#include <gtest/gtest.h>

#include "base/error.h"

using namespace lobe;

namespace {
constexpr std::uint64_t MiB = 1 << 20;

std::string refusal(MemoryAccount& account, std::uint64_t count, std::uint64_t size) {
    try {
        account.reserve(count, size, "the film");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::device);
        return error.what();
    }
    return "";
}
}  // namespace

TEST(MemoryAccount, CountsUseAndPeak) {
    MemoryAccount account(10 * MiB, 6 * MiB);
    EXPECT_EQ(account.reserve(3, MiB, "a"), 3 * MiB);
    EXPECT_EQ(account.reserve(6, MiB, "b"), 6 * MiB);
    account.release(3 * MiB);
    EXPECT_EQ(account.used(), 6 * MiB);
    EXPECT_EQ(account.peak(), 9 * MiB);
}

TEST(MemoryAccount, RefusesBeforeTheDriverLies) {
    MemoryAccount account(10 * MiB, 6 * MiB);
    account.reserve(5, MiB, "a");
    EXPECT_EQ(
        refusal(account, 7, MiB),
        "the film needs 7.0 MiB of the device's memory, but one buffer may have 6.0 MiB at most");
    EXPECT_EQ(refusal(account, 6, MiB),
              "the film needs 6.0 MiB of the device's memory, but 5.0 MiB of 10.0 MiB are free");
    EXPECT_NE(refusal(account, (std::uint64_t{1} << 61) + 1, 8), "");  // the product wraps to 8
    EXPECT_EQ(account.used(), 5 * MiB);
    EXPECT_EQ(refusal(account, 5, MiB), "");
}
