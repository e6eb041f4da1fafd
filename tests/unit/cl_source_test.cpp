// SPDX-License-Identifier: Apache-2.0
#include "cl/source.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/kernel_text.h"
#include "support/temp_folder.h"

using namespace lobe;
using lobe::test::TempFolder;

namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace

TEST(Flatten, KeepsFileAndLine) {
    const TempFolder folder;
    folder.write("main.cl", "one\n#include \"a/b.h\"\nthree\n");
    folder.write("a/b.h", "inner\r\n  #  include  \"c.h\" // why\nlast\n");
    folder.write("c.h", "deep");
    EXPECT_EQ(flatten(KernelText(folder.path()), "main.cl"),
              "#line 1 \"main.cl\"\none\n"
              "#line 1 \"a/b.h\"\ninner\n"
              "#line 1 \"c.h\"\ndeep\n"
              "#line 3 \"a/b.h\"\nlast\n"
              "#line 3 \"main.cl\"\nthree\n");
}

TEST(Flatten, HeadersComeOnceAndTablesEveryTime) {
    const TempFolder folder;
    folder.write("main.cl",
                 "#include \"x.h\"\n#include \"y.h\"\n#include \"x.h\"\n#include \"z.h\"\n"
                 "#include \"t.def\"\n#include \"t.def\"\n");
    folder.write("x.h", "XX\n");
    folder.write("y.h",
                 "#ifndef Y_H\n#define Y_H\n#include \"x.h\"\n#include \"z.h\"\nYY\n#endif\n");
    folder.write("z.h", "ZZ\n");
    folder.write("t.def", "ROW\n");
    const std::string text = flatten(KernelText(folder.path()), "main.cl");
    EXPECT_EQ(occurrences(text, "XX\n"), 1u);
    EXPECT_EQ(occurrences(text, "YY\n"), 1u);
    EXPECT_EQ(occurrences(text, "ZZ\n"), 1u);  // y.h's guard is no condition
    EXPECT_EQ(occurrences(text, "ROW\n"), 2u);
}

// What a false #if hides must still come where it is asked for again.
TEST(Flatten, AConditionalIncludeDoesNotCountAsIncluded) {
    const TempFolder folder;
    folder.write("main.cl",
                 "#if LOBE_HAS_A\n#include \"x.h\"\n#endif\n#include \"x.h\"\n#include \"x.h\"\n");
    folder.write("x.h", "#ifndef X_H\n#define X_H\n#include \"z.h\"\nXX\n#endif\n");
    folder.write("z.h", "#ifndef Z_H\n#define Z_H\nZZ\n#endif\n");
    const std::string text = flatten(KernelText(folder.path()), "main.cl");
    EXPECT_EQ(occurrences(text, "XX\n"), 2u);
    EXPECT_EQ(occurrences(text, "ZZ\n"), 2u);
}

TEST(Flatten, GeneratedTextsTakePrecedence) {
    const TempFolder folder;
    folder.write("main.cl", "#include \"lobe_scene.h\"\n#include \"b.h\"\n");
    folder.write("b.h", "file\n");
    const std::string text =
        flatten(KernelText(folder.path()), "main.cl",
                {{"lobe_scene.h", "made\n#include \"b.h\"\n"}, {"b.h", "mine\n"}});
    EXPECT_EQ(occurrences(text, "made\n"), 1u);
    EXPECT_EQ(occurrences(text, "mine\n"), 1u);
    EXPECT_EQ(occurrences(text, "file\n"), 0u);
}

TEST(Flatten, CommentsAreNoIncludes) {
    const TempFolder folder;
    folder.write(
        "main.cl",
        "/* text\n#include \"no.h\"\n*/ // /*\n// #include \"no.h\"\n\"/*\"\n#include \"x.h\"\n");
    folder.write("x.h", "XX\n");
    const std::string text = flatten(KernelText(folder.path()), "main.cl");
    EXPECT_EQ(occurrences(text, "XX\n"), 1u);
    EXPECT_EQ(occurrences(text, "\n#include \"no.h\""), 1u);  // left as it was
}

TEST(Flatten, LeavesIncludesOfTheLanguageAlone) {
    const TempFolder folder;
    folder.write("main.cl", "#include <cstdint>\n");
    EXPECT_EQ(flatten(KernelText(folder.path()), "main.cl"),
              "#line 1 \"main.cl\"\n#include <cstdint>\n");
}

TEST(Flatten, CyclesEnd) {
    const TempFolder folder;
    folder.write("a.h", "#if 1\n#include \"b.h\"\n#endif\nAA\n");
    folder.write("b.h", "#if 1\n#include \"a.h\"\n#endif\nBB\n");
    const std::string text = flatten(KernelText(folder.path()), "a.h");
    EXPECT_EQ(occurrences(text, "AA\n"), 1u);
    EXPECT_EQ(occurrences(text, "BB\n"), 1u);
}

// A user's own file may include what lies beside it, and that in turn; kernels may not.
TEST(Flatten, NeighboursOfAnAddedText) {
    const TempFolder folder, own;
    folder.write("core/real.h", "REAL\n");
    folder.write("main.cl", "#include \"lobe_scene.h\"\n");
    own.write("noise.h", "#include \"more/deep.h\"\nNOISE\n");
    own.write("more/deep.h", "DEEP\n");
    own.write("core/real.h", "not this one\n");
    const std::string path = own.file("velvet.cl");
    KernelText kernels(folder.path());
    kernels.add(path, "#include \"core/real.h\"\n#include \"noise.h\"\n#include \"noise.h\"\n");
    const std::map<std::string, std::string> scene = {
        {"lobe_scene.h", "#include \"" + path + "\"\n"}};
    const std::string text = flatten(kernels, "main.cl", scene);
    for (const char* part : {"REAL\n", "NOISE\n", "DEEP\n"})
        EXPECT_EQ(occurrences(text, part), 1u) << part;
    EXPECT_EQ(occurrences(text, "not this one"), 0u);
    EXPECT_NE(text.find("#line 1 \"" + own.file("more/deep.h") + "\"\nDEEP"), std::string::npos);

    folder.write("core/real.h", "#include \"beside.h\"\n");
    folder.write("core/beside.h", "");
    EXPECT_THROW(flatten(kernels, "main.cl", scene), Error);
}

TEST(Flatten, AFileThatAUsersOwnLacksIsTheUsersFault) {
    KernelText kernels;
    kernels.add("velvet.cl", "\n  #include \"brdf/lobes.h\"\n");
    try {
        flatten(kernels, "velvet.cl");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::scene);
        EXPECT_EQ(error.where(), "velvet.cl:2:3");
        EXPECT_NE(error.hint().find("brdf/lobe.h"), std::string::npos) << error.hint();
    }
}

TEST(Flatten, MissingFileSaysWhere) {
    const TempFolder folder;
    folder.write("main.cl", "\n#include \"core/reel.h\"\n");
    folder.write("core/real.h", "");
    folder.write("macro.cl", "#include NAME\n");
    try {
        flatten(KernelText(folder.path()), "main.cl");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::device);
        EXPECT_EQ(error.where(), "main.cl:2:1");
        EXPECT_NE(error.hint().find("core/real.h"), std::string::npos) << error.hint();
    }
    EXPECT_THROW(flatten(KernelText(folder.path()), "macro.cl"), Error);
    EXPECT_THROW(flatten(KernelText(folder.path()), "none.cl"), Error);
}
