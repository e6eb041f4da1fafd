// SPDX-License-Identifier: Apache-2.0
#include "base/child.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "base/signals.h"
#include "base/timer.h"

using namespace lobe;

namespace {

std::vector<std::string> shell(const std::string& script) { return {"/bin/sh", "-c", script}; }

// Lines until the end, each followed by a '|'.
std::string all_lines(Child& child) {
    std::string all, line;
    while (child.read_line(line, 30) == Child::Read::line) all += line + "|";
    return all;
}

}  // namespace

TEST(Child, GivesLinesErrorsAndCode) {
    Child child(shell("echo one; echo wrong >&2; printf 'two\\n\\nlast without end'; exit 7"));
    EXPECT_EQ(all_lines(child), "one|two||");
    const ChildEnd end = child.wait();
    EXPECT_EQ(end.code, 7);
    EXPECT_EQ(end.signal, 0);
    EXPECT_EQ(child.errors(), "wrong\n");
}

TEST(Child, PassesWordsUntouched) {
    Child child({"/bin/sh", "-c", "printf '%s\\n' \"$1\"; wc -c", "sh", "x \"y\" *"});
    EXPECT_EQ(all_lines(child), "x \"y\" *|0|");  // and standard input is empty
}

TEST(Child, TellsTheSignal) {
    Child child(shell("ulimit -c; kill -SEGV $$"));
    EXPECT_EQ(all_lines(child), "0|");
    EXPECT_EQ(child.wait().signal, SIGSEGV);
    Child missing({"/no/such/program"});
    EXPECT_EQ(all_lines(missing), "");
    EXPECT_EQ(missing.wait().code, 127);
}

TEST(Child, IsLateAndIsKilled) {
    const Stopwatch watch;
    {
        Child child(shell("echo first; exec sleep 60"));
        std::string line;
        EXPECT_EQ(child.read_line(line, 30), Child::Read::line);
        EXPECT_EQ(child.read_line(line, 0.1), Child::Read::late);
    }
    EXPECT_LT(watch.seconds(), 20);
}

TEST(Child, DropsWhatWouldBeTooMuch) {
    Child child(shell("head -c 3000000 /dev/zero >&2; echo done"));
    EXPECT_EQ(all_lines(child), "done|");
    EXPECT_EQ(child.errors().size(), 65536u);
}

TEST(ChildDeathTest, ASignalToUsInterrupts) {
    const auto work = [] {
        install_signal_handlers();
        Child child(shell("sleep 0.2; kill -TERM $PPID; exec sleep 60"));
        std::string line;
        std::_Exit(child.read_line(line, 30) == Child::Read::interrupted ? 3 : 4);
    };
    EXPECT_EXIT(work(), testing::ExitedWithCode(3), "");
}
