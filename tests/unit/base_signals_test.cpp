// SPDX-License-Identifier: Apache-2.0
#include "base/signals.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

using namespace lobe;

TEST(SignalsDeathTest, FirstAsksToStop) {
    const auto work = [](int signal) {
        install_signal_handlers();
        if (stop_signal()) std::_Exit(1);
        std::raise(signal);
        std::_Exit(stop_signal() == signal ? stop_exit_code() : 2);
    };
    EXPECT_EXIT(work(SIGINT), testing::ExitedWithCode(130), "");
    EXPECT_EXIT(work(SIGTERM), testing::ExitedWithCode(143), "");
}

TEST(SignalsDeathTest, SecondEndsAtOnce) {
    const auto work = [] {
        install_signal_handlers();
        std::raise(SIGINT);
        std::raise(SIGTERM);
        std::_Exit(0);
    };
    EXPECT_EXIT(work(), testing::ExitedWithCode(143), "");
}
