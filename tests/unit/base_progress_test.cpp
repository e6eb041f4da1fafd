// SPDX-License-Identifier: Apache-2.0
#include "base/progress.h"

#include <gtest/gtest.h>

#include "base/log.h"

using namespace lobe;

namespace {
const ProgressState halfway{"render", "samples", 5e6, 1e7, 4, "error 2.1 %"};
}

TEST(Progress, TextHasRateAndRemainingTime) {
    EXPECT_EQ(progress_text(halfway), "render   50 %  1.25 Msamples/s  ETA 0:04  error 2.1 %");
    ProgressState endless = halfway;
    endless.total = 0;
    EXPECT_EQ(progress_text(endless), "render  1.25 Msamples/s  0:04  error 2.1 %");
    EXPECT_EQ(progress_text({"render", "samples", 0, 100, 0, ""}), "render    0 %");
}

TEST(Progress, NeverSaysHundredTooEarlyNorMore) {
    EXPECT_NE(progress_text({"x", "s", 999, 1000, 1, ""}).find(" 99 %"), std::string::npos);
    EXPECT_NE(progress_text({"x", "s", 1500, 1000, 1, ""}).find("100 %"), std::string::npos);
}

TEST(Progress, BarFitsTheTerminal) {
    for (unsigned columns : {0u, 5u, 40u, 60u, 70u, 80u, 200u})
        EXPECT_LE(progress_bar(halfway, columns, false).size(), columns);
    EXPECT_EQ(progress_bar(halfway, 70, false),
              "[#######.......] render   50 %  1.25 Msamples/s  ETA 0:04  error 2.1 %");
    EXPECT_EQ(progress_bar(halfway, 200, false).find('\x1b'), std::string::npos);
    EXPECT_NE(progress_bar(halfway, 200, true).find('\x1b'), std::string::npos);
}

TEST(Progress, Amounts) {
    EXPECT_EQ(amount_text(1.304e6, "rays"), "1.30 Mrays");
    EXPECT_EQ(amount_text(999.9, "rays"), "1.00 krays");
    EXPECT_EQ(amount_text(12.34, "rays"), "12.3 rays");
    EXPECT_EQ(bytes_text(5), "5 bytes");
    EXPECT_EQ(bytes_text(3.25 * (1u << 30)), "3.2 GiB");
    EXPECT_EQ(bytes_text(1048575), "1.0 MiB");
    EXPECT_EQ(duration_text(7), "0:07");
    EXPECT_EQ(duration_text(3599.6), "1:00:00");
    EXPECT_EQ(duration_text(3723), "1:02:03");
    EXPECT_EQ(duration_text(-1), "?");
}

TEST(Log, QuietHidesNotesButNotWarnings) {
    testing::internal::CaptureStderr();
    note("one");
    set_quiet(true);
    note("two");
    warn("three\x1b", "a.pbrt:1:2");
    set_quiet(false);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "lobe: one\nlobe: warning: a.pbrt:1:2: three\\x1b\n");
}

TEST(Log, LinesPassAboveTheLiveLine) {
    testing::internal::CaptureStderr();
    show_live_line("50 %");
    note("hello");
    show_live_line("");
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "\r\x1b[K50 %\r\x1b[Klobe: hello\n50 %\r\x1b[K");
}
