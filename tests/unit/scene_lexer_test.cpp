// SPDX-License-Identifier: Apache-2.0
#include "scene/lexer.h"

#include <gtest/gtest.h>

#include "base/error.h"

using namespace lobe;

namespace {

std::string tokens(const std::string& text) {
    const auto file = make_source("f", text);
    Lexer lexer(*file);
    std::string out;
    for (Token t = lexer.next(); t.kind != TokenKind::end; t = lexer.next()) {
        out += out.empty() ? "" : " ";
        out += t.kind == TokenKind::quoted ? "<" + std::string(t.text) + ">" : std::string(t.text);
        out += to_string(t.place).substr(1);
    }
    return out;
}

std::string fault(const std::string& text) {
    try {
        tokens(text);
    } catch (const Error& error) {
        return error.where() + " " + error.what();
    }
    return "";
}

}  // namespace

TEST(Lexer, KnowsWhereTokensStand) {
    EXPECT_EQ(tokens("Shape \"sphere\"\n  [1 2]"),
              "Shape:1:1 <sphere>:1:7 [:2:3 1:2:4 2:2:6 ]:2:7");
}

TEST(Lexer, NeedsNoBlanksAroundBracketsAndQuotes) {
    EXPECT_EQ(tokens("a\"b\"[c]"), "a:1:1 <b>:1:2 [:1:5 c:1:6 ]:1:7");
}

TEST(Lexer, LeavesOutCommentsEverywhere) {
    EXPECT_EQ(tokens("#x\na#y \"[\n[#z\n1]"), "a:2:1 [:3:1 1:4:1 ]:4:2");
    EXPECT_EQ(tokens("\"a # b\""), "<a # b>:1:1");
}

TEST(Lexer, ReadsWindowsLinesAndByteOrderMarks) {
    EXPECT_EQ(tokens("\xef\xbb\xbf"
                     "a\r\nb\r\n"),
              "a:1:1 b:2:1");
}

TEST(Lexer, KeepsEscapesAndResolvesThem) {
    EXPECT_EQ(tokens(R"("a\"b" c)"), R"(<a\"b>:1:1 c:1:8)");
    EXPECT_EQ(unescape(R"(a\"b\\c\n\q)"), "a\"b\\c\n\\q");
}

TEST(Lexer, SaysWhereAStringBeganThatDoesNotEnd) {
    EXPECT_EQ(fault("a\n \"b\nc\""), "f:2:2 a string that does not end on its line");
    EXPECT_EQ(fault("\"b\\\nc\""), "f:1:1 a string that does not end on its line");
    EXPECT_EQ(fault("\"b\\"), "f:1:1 a string that does not end on its line");
}

TEST(Lexer, RefusesBytesThatNoTextHas) {
    EXPECT_EQ(fault(std::string("a\nb\0c", 5)), "f:2:2 a NUL byte in a scene file");
    EXPECT_EQ(fault("\x1f\x8b"), "f compressed scene files are not supported");
}

TEST(Lexer, TakesTokensOfAnyLength) {
    const std::string word(3000000, 'x');
    EXPECT_EQ(tokens(word), word + ":1:1");
}
