// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "base/error.h"
#include "base/files.h"
#include "base/kernel_text.h"
#include "support/probe.h"
#include "base/random.h"
#include "support/temp_folder.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const char* const twice = R"(
kernel void twice(global const float* in, float factor, global float* out) {
    size_t i = get_global_id(0);
    out[i] = factor * in[i];
})";

// a b - b a is 0 unless one of the products is fused into the difference.
const char* const contraction = R"(
kernel void difference(global const float* a, global const float* b, global float* out) {
    size_t i = get_global_id(0);
    out[i] = a[i] * b[i] - b[i] * a[i];
})";

}  // namespace

TEST(BuildProgram, RunsAKernel) {
    const Program program = build_program(test_device(), twice);
    EXPECT_GT(program.build_seconds, 0);
    EXPECT_FALSE(program.cached);
    EXPECT_EQ(program.key.size(), 64u);
    const Buffer<float> in(test_device(), std::vector<float>{1, 2, 3});
    const Buffer<float> out(test_device(), 3);
    run_probe(program, "twice", 3, in, 2.0f, out);
    EXPECT_EQ(out.read_all(), (std::vector<float>{2, 4, 6}));
}

TEST(BuildProgram, FailureNamesFileAndLineAndKeepsTheEvidence) {
    const TempFolder cache, folder;
    const ScopedVariable variable("LOBE_CACHE_DIR", cache.path().c_str());
    folder.write("main.cl",
                 "\n#include \"core/bad.h\"\nkernel void k(global int* x) { *x = f(); }\n");
    folder.write("core/bad.h", "// fine\nint f() {\n    return undeclared_name;\n}\n");
    try {
        build_program(test_device(), flatten(KernelText(folder.path()), "main.cl"));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::device);
        EXPECT_EQ(error.where().find("core/bad.h:3"), 0u) << error.message();
        EXPECT_NE(std::string(error.what()).find("undeclared_name"), std::string::npos);
        const auto at = error.hint().find(cache.path());
        ASSERT_NE(at, std::string::npos) << error.hint();
        const std::string evidence = read_file(error.hint().substr(at));
        EXPECT_NE(evidence.find("return undeclared_name;"), std::string::npos);
        EXPECT_NE(evidence.find("undeclared identifier"), std::string::npos) << "the log";
    }
}

TEST(BuildProgram, FailureIsToldWithoutAnyCacheFolder) {
    const ScopedVariable variable("LOBE_CACHE_DIR", "/dev/null/no");
    EXPECT_THROW(build_program(test_device(), "kernel void k( {"), Error);
}

// PoCL shows its device but builds nothing, and its log is empty.
TEST(BuildProgramDeathTest, PoclWithAFullOrForeignCacheFolder) {
    const std::string pocl = "/etc/OpenCL/vendors/pocl.icd";
    if (!std::filesystem::exists(pocl)) GTEST_SKIP() << "no PoCL";
    const auto build = [&] {
        setenv("OCL_ICD_VENDORS", pocl.c_str(), 1);
        setenv("POCL_CACHE_DIR", "/proc", 1);
        try {
            build_program(open_device("0"), twice);
        } catch (const Error& error) {
            std::cerr << error.message() << std::endl;
            std::_Exit(static_cast<int>(error.code()));
        }
        std::_Exit(0);
    };
    EXPECT_EXIT(build(), testing::ExitedWithCode(4), "does not build.*\n.*POCL_CACHE_DIR=/proc");
}

TEST(BuildProgram, NeverContractsProducts) {
    Random random(1);
    std::vector<float> a(4096), b(4096);
    for (float& x : a) x = static_cast<float>(random.uniform(1, 2));
    for (float& x : b) x = static_cast<float>(random.uniform(1, 2));
    const Buffer<float> in_a(test_device(), a), in_b(test_device(), b), out(test_device(), 4096);
    run_probe(build_program(test_device(), contraction), "difference", 4096, in_a, in_b, out);
    EXPECT_EQ(out.read_all(), std::vector<float>(4096, 0));
}

TEST(BuildProgram, DoubleIsAsked) {
    const char* text =
        "#ifdef LOBE_DOUBLE\n#pragma OPENCL EXTENSION cl_khr_fp64 : enable\ntypedef double real;\n"
        "#else\ntypedef float real;\n#endif\n"
        "kernel void size(global uint* out) { *out = sizeof(real); }";
    const Buffer<cl_uint> out(test_device(), 1);
    run_probe(build_program(test_device(), text), "size", 1, out);
    EXPECT_EQ(out.read_all()[0], 4u);
    LOBE_NEEDS_DOUBLE();
    run_probe(build_program(test_device(), text, {true}), "size", 1, out);
    EXPECT_EQ(out.read_all()[0], 8u);
}

TEST(BuildProgram, MistakesInCallsHaveNames) {
    const Program program = build_program(test_device(), twice);
    const Buffer<float> in(test_device(), 3);
    EXPECT_THROW(program.kernel("thrice"), Error);
    try {
        run_probe(program, "twice", 3, in, 2.0, in);  // a double is no float
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("argument 1 of kernel twice"), std::string::npos);
    }
    EXPECT_THROW(run_probe(program, "twice", 3, in, 2.0f), Error);
}

// Everything that the kernels can do compiles together.
TEST(BuildProgram, BuildsTheGeneralKernel) {
    const Program program = build_probe("render.cl");
    EXPECT_NE(program.kernel("render")(), nullptr);
    EXPECT_NE(program.kernel("prepare")(), nullptr);
    EXPECT_EQ(program.log, "");
}
