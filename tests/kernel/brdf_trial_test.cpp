// SPDX-License-Identifier: Apache-2.0
// The first run of a model in a process of its own: the fences around its memory, and that sound
// models stand it.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/kernel_text.h"
#include "lab/trial/guarded_buffer.h"
#include "lab/trial/trial_run.h"
#include "support/probe.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// A kernel that writes one number at an index of a buffer, or reads there.
class Writer {
  public:
    Writer()
        : program_(build_program(test_device(),
                                 "kernel void put(global uint* to, int i) { to[i] = 7; }\n"
                                 "kernel void get(global uint* to, int i) { to[0] = to[i]; }\n")) {}

    void run(const char* name, const GuardedBuffer& buffer, cl_int index) const {
        cl::Kernel kernel = program_.kernel(name);
        set_args(kernel, buffer.get(), index);
        launch(test_device(), kernel, cl::NDRange(1), cl::NDRange(1));
        test_device().finish();
    }

  private:
    Program program_;
};

std::vector<cl_uint> content(const GuardedBuffer& buffer, std::size_t count) {
    std::vector<cl_uint> numbers(count);
    test_device().queue().enqueueReadBuffer(buffer.get(), CL_TRUE, 0, 4 * count, numbers.data());
    return numbers;
}

}  // namespace

TEST(GuardedBuffer, HoldsWhatItIsGiven) {
    const std::vector<cl_uint> numbers = {1, 2, 3};
    const GuardedBuffer copy(test_device(), 12, numbers.data()), zeros(test_device(), 5000);
    EXPECT_EQ(content(copy, 3), numbers);
    EXPECT_EQ(content(zeros, 1250), std::vector<cl_uint>(1250, 0));
    const Writer writer;
    writer.run("put", copy, 2);
    EXPECT_EQ(content(copy, 3), (std::vector<cl_uint>{1, 2, 7}));
    EXPECT_TRUE(copy.intact());
    EXPECT_TRUE(zeros.intact());
    EXPECT_TRUE(GuardedBuffer(test_device(), 0).intact());
}

TEST(GuardedBuffer, SeesStoresBesideIt) {
    const Writer writer;
    for (const cl_int index : {-1, 3}) {
        const GuardedBuffer buffer(test_device(), 12);
        writer.run("put", buffer, index);
        EXPECT_FALSE(buffer.intact()) << index;
    }
}

TEST(GuardedBufferDeathTest, EndsTheProcessFurtherOut) {
    if (!(test_device().info().type & CL_DEVICE_TYPE_CPU))
        GTEST_SKIP() << "the device has memory of its own: " << test_device().info().name;
    const auto far = [](const char* name, cl_int index) {
        const GuardedBuffer buffer(test_device(), 128);
        Writer().run(name, buffer, index);
    };
    EXPECT_DEATH(far("put", 32), "");
    EXPECT_DEATH(far("get", 32), "");
    EXPECT_DEATH(far("put", -1024), "");
    EXPECT_DEATH(far("get", -1024), "");
}

// Garbage in, anything out, but back they come.
TEST(Trial, EveryModelOfLobeStandsIt) {
    const KernelText kernels;
    for (const BrdfTable& model : read_brdf_tables(kernels)) {
        SCOPED_TRACE(model.name);
        std::vector<std::string> steps;
        EXPECT_NO_THROW(run_trial(test_device(), kernels, model,
                                  [&](const std::string& step) { steps.push_back(step); }));
        ASSERT_GE(steps.size(), 4u);
        EXPECT_EQ(steps[0], "the build");
        EXPECT_EQ(steps[1], model.name + "_prepare");
        for (const char* function : {"_eval", "_sample"})
            EXPECT_NE(std::find(steps.begin(), steps.end(), model.name + function), steps.end());
    }
}

TEST(Trial, APreparedFormThatIsTooLargeIsTold) {
    std::string text = KernelText().read("brdf/lambert.h");
    for (std::size_t at = 0; (at = text.find("lambert", at)) != std::string::npos;)
        text.replace(at, 7, "large");
    const std::string member = "real3 kd;\n}";
    text.replace(text.find(member), member.size(), "real3 kd;\n    real rest[300];\n}");
    KernelText kernels;
    kernels.add("large.cl", text);
    for (const BrdfTable& model : read_brdf_tables(kernels)) {
        if (!model.own) continue;
        try {
            run_trial(test_device(), kernels, model, [](const std::string&) {});
            FAIL() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::scene);
            EXPECT_EQ(error.where(), "large.cl");
            EXPECT_NE(std::string(error.what()).find("large_prepared has"), std::string::npos)
                << error.what();
        }
    }
}
