// SPDX-License-Identifier: Apache-2.0
#include "render/watchdog.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

using namespace lobe;

namespace {

void sleep_seconds(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace

TEST(Watchdog, FiresForALaunchThatDoesNotEnd) {
    std::atomic<double> told{0};
    std::atomic<bool> over{false};
    Watchdog dog(0.3, [&](double seconds) {
        told = seconds;
        sleep_seconds(0.5);
        over = true;
    });
    {
        const Watchdog::Launch launch(&dog, 0);
        while (told == 0) sleep_seconds(0.01);
    }
    EXPECT_TRUE(over) << "the launch's end waits for what the dog does";
    EXPECT_EQ(told, 0.3);
}

TEST(Watchdog, LeavesShortLaunchesAlone) {
    std::atomic<int> fired{0};
    {
        Watchdog dog(0.6, [&](double) { ++fired; });
        for (int i = 0; i < 10; ++i) {
            const Watchdog::Launch launch(&dog, 0);
            sleep_seconds(0.1);
        }
        sleep_seconds(1);  // between launches nothing is watched
        const Watchdog::Launch none(nullptr, 1);
    }
    EXPECT_EQ(fired, 0);
}

TEST(Watchdog, ZeroIsNoWatch) {
    std::atomic<int> fired{0};
    Watchdog dog(0, [&](double) { ++fired; });
    const Watchdog::Launch launch(&dog, 0);
    sleep_seconds(0.6);
    EXPECT_EQ(fired, 0);
}

// The limit follows the device: a slow one is known by its first launches.
TEST(Watchdog, TheLimitFollowsThePace) {
    Watchdog dog(60, [](double) {});
    EXPECT_EQ(dog.limit(0), 60);
    EXPECT_NEAR(dog.limit(5600), 60 + 112, 1e-9);  // one row for a simulator
    {
        const Watchdog::Launch launch(&dog, 1000);
        sleep_seconds(0.1);
    }
    const double rest = dog.limit(1000) - 60;
    EXPECT_GE(rest, 100 * 0.1);
    EXPECT_LT(rest, 100 * 5.0);
    EXPECT_NEAR(dog.limit(4000) - 60, 4 * rest, 1e-6);
    EXPECT_NEAR(dog.limit(10) - 60, rest, 1e-6);
    {
        const Watchdog::Launch slow(&dog, 10);  // a small launch teaches nothing
        sleep_seconds(0.3);
    }
    EXPECT_NEAR(dog.limit(4000) - 60, 4 * rest, 1e-6);
    { const Watchdog::Launch quick(&dog, 4000); }  // a larger one does
    EXPECT_LT(dog.limit(4000) - 60, rest);
}
