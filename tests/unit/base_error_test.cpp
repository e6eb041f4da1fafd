// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"

#include <gtest/gtest.h>

#include <vector>

using namespace lobe;

TEST(Error, MessageHasPlaceAndHint) {
    const Error error(ExitCode::scene, "unknown shape \"sfere\"", "a.pbrt:3:7",
                      "did you mean sphere?");
    EXPECT_EQ(error.message(),
              "lobe: error: a.pbrt:3:7: unknown shape \"sfere\"\nlobe: hint: did you mean sphere?");
    EXPECT_EQ(Error(ExitCode::device, "no device").message(), "lobe: error: no device");
    EXPECT_EQ(static_cast<int>(error.code()), 3);
}

TEST(Error, ControlBytesCannotReachTheTerminal) {
    const std::string evil("a\x1b[31m\n\t\0\x7f", 10);
    EXPECT_EQ(Error(ExitCode::scene, evil, "x\ny").message(),
              "lobe: error: x\\ny: a\\x1b[31m\\n\\t\\x00\\x7f");
}

TEST(Error, PrintableKeepsUtf8AndEscapesTheRest) {
    EXPECT_EQ(printable("straße \u20ac \U0001f600"), "straße \u20ac \U0001f600");
    EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
    EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");           // CSI as one character
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");           // overlong
    EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");  // overlong
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // surrogate
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

TEST(EditDistance, CountsEdits) {
    EXPECT_EQ(edit_distance("", ""), 0u);
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(edit_distance("rational", "ratoinal"), 1u);  // neighbours swapped
    EXPECT_EQ(edit_distance("abc", "abc"), 0u);
    EXPECT_EQ(edit_distance("abcd", "acb"), 2u);
}

TEST(NearestName, FindsTyposAndRefusesStrangers) {
    const std::vector<std::string> names = {"matte", "metal", "rational", "phong"};
    EXPECT_EQ(nearest_name("mate", names), "matte");
    EXPECT_EQ(nearest_name("ratioanl", names), "rational");
    EXPECT_EQ(nearest_name("transmission", names), "");
    EXPECT_EQ(nearest_name("x", std::vector<std::string>{}), "");
}
