// SPDX-License-Identifier: Apache-2.0
// Build logs as compilers write them.
#include <gtest/gtest.h>

#include "cl/cl_error.h"
#include "base/error.h"
#include "cl/build_log.h"

using namespace lobe;

TEST(FirstFault, PoclPutsErrorFirst) {
    const BuildFault fault = first_fault(
        "warning: core/vec.h:1:2: unused\n"
        "error: core/real.h:5:40: unknown type name 'rael'\n"
        "error: core/real.h:9:1: another\n",
        "");
    EXPECT_EQ(fault.where, "core/real.h:5:40");
    EXPECT_EQ(fault.what, "unknown type name 'rael'");
}

TEST(FirstFault, ClangPutsThePlaceFirst) {
    const BuildFault fault = first_fault(
        "core/vec.h:1:2: warning: this is no error\r\n"
        "my folder/velvet.cl:12:3: fatal error: expected ';'\r\n",
        "");
    EXPECT_EQ(fault.where, "my folder/velvet.cl:12:3");
    EXPECT_EQ(fault.what, "expected ';'");
}

// Oclgrind counts the lines of the whole text and gives it a name of its own.
TEST(FirstFault, LinesOfTheWholeTextAreFoundAgain) {
    const std::string text =
        "#pragma\n"
        "#line 1 \"main.cl\"\n\n"
        "#line 1 \"core/bad.h\"\n// fine\nint f() {\n    return x;\n"
        "#line 3 \"main.cl\"\nkernel\n";
    EXPECT_EQ(first_fault("input.cl:7:12: error: no x\n", text).where, "core/bad.h:3:12");
    EXPECT_EQ(first_fault("input.cl:9:1: error: no\n", text).where, "main.cl:3:1");
    EXPECT_EQ(first_fault("input.cl:3:1: error: no\n", text).where, "main.cl:1:1");
    EXPECT_EQ(first_fault("input.cl:1:1: error: no\n", text).where, "input.cl:1:1");
    EXPECT_EQ(first_fault("core/bad.h:3:12: error: no x\n", text).where, "core/bad.h:3:12");
}

TEST(FirstFault, WithoutAPlaceTheTextMustDo) {
    const BuildFault fault =
        first_fault("ptxas error : too much shared data\nerror: no memory\n", "");
    EXPECT_EQ(fault.where, "");
    EXPECT_EQ(fault.what, "no memory");
    EXPECT_EQ(first_fault("", "").what, "");
    EXPECT_EQ(first_fault("all is well\n", "").what, "");
}

TEST(ClError, EveryErrorHasANameAndANumber) {
    EXPECT_STREQ(cl_error_name(-5), "CL_OUT_OF_RESOURCES");
    EXPECT_STREQ(cl_error_name(-72), "CL_MAX_SIZE_RESTRICTION_EXCEEDED");
    EXPECT_STREQ(cl_error_name(-1001), "CL_PLATFORM_NOT_FOUND_KHR");
    EXPECT_STREQ(cl_error_name(-4711), "unknown code");
    try {
        checked([]() -> int { throw cl::Error(-61, "clCreateBuffer"); });
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::device);
        EXPECT_STREQ(error.what(), "clCreateBuffer failed: CL_INVALID_BUFFER_SIZE (-61)");
    }
    EXPECT_EQ(checked([] { return 7; }), 7);
}
