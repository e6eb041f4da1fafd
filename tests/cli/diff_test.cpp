// SPDX-License-Identifier: Apache-2.0
// lobe diff: what passes, what fails, and what is refused.
#include <algorithm>
#include <cmath>

#include "cli.h"
#include "report/image_io.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Two by one pixels of these values in R, G, B, with errors or without.
ImageFile tiny(float first, float second, bool errors = false) {
    ImageFile image;
    image.width = image.full_width = 2;
    image.height = image.full_height = 1;
    image.channels = {"R", "G", "B"};
    if (errors)
        image.channels.insert(image.channels.end(), {"StdError.R", "StdError.G", "StdError.B"});
    for (const float v : {first, second}) {
        image.pixels.insert(image.pixels.end(), 3, v);
        if (errors) image.pixels.insert(image.pixels.end(), 3, 0.25f);
    }
    return image;
}

class Diff : public Cli {
  protected:
    void write(const std::string& name, const ImageFile& image) {
        images_.write(path(name), image);
    }
    // lobe diff ARGUMENTS... --json -; it must end with `code`.
    nlohmann::json diff(std::vector<std::string> arguments, int code) {
        arguments.insert(arguments.begin(), "diff");
        arguments.insert(arguments.end(), {"--json", "-"});
        const RunResult result = lobe(arguments);
        EXPECT_EQ(result.code, code) << joined(arguments) << "\n" << result.err;
        return nlohmann::json::parse(result.out, nullptr, false);
    }
    ImageIo images_;
};

}  // namespace

TEST_F(Diff, IdenticalIsIdentical) {
    write("a.exr", tiny(1, 2));
    const RunResult result = lobe({"diff", "a.exr", "a.exr"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, "identical: every value has the same bits\n");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(diff({"a.exr", "a.exr", "--tolerance", "0"}, 0)["verdict"], "identical");
    const RunResult quiet = lobe({"diff", "a.exr", "a.exr", "--quiet"});
    EXPECT_EQ(quiet.code, 0);
    EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(Diff, WithoutErrorsTheToleranceDecides) {
    write("a.exr", tiny(1, 2));
    write("b.exr", tiny(1, 2.25f));
    const auto plain = diff({"a.exr", "b.exr"}, 8);
    EXPECT_EQ(plain["verdict"], "differ");
    EXPECT_TRUE(plain["metrics"]["p_same"].is_null());
    const double relative = std::sqrt(0.0625 / 2) / 1.625;
    EXPECT_NEAR(plain["worst_relative_rmse"], relative, 1e-9);
    EXPECT_NEAR(plain["metrics"]["channels"]["R"]["mse_raw"], 0.03125, 1e-9);
    EXPECT_EQ(diff({"a.exr", "b.exr", "--tolerance", "0.11"}, 0)["verdict"], "same");
    EXPECT_EQ(diff({"a.exr", "b.exr", "--tolerance", "0.1"}, 8)["verdict"], "differ");
    const RunResult text = lobe({"diff", "a.exr", "b.exr"});
    EXPECT_EQ(text.code, 8);
    for (const char* word : {"luminance", "RMSE / mean", "SMAPE", "differ: not identical"})
        EXPECT_NE(text.out.find(word), std::string::npos) << text.out;
    expect_fault(lobe({"diff", "a.exr", "b.exr", "--level", "0.01"}), 3,
                 "a.exr: --level is of a test that needs standard errors", "--tolerance");
    EXPECT_EQ(lobe({"diff", "a.exr", "b.exr", "--tolerance", "-1"}).code, 2);
    EXPECT_EQ(lobe({"diff", "a.exr", "b.exr", "--level", "nan"}).code, 2);
}

// What other tools let pass.
TEST_F(Diff, NanAndInfNeverPass) {
    const float nan = std::nanf("");
    write("zero.exr", tiny(0, 1));
    write("nan.exr", tiny(nan, 1));
    write("inf.exr", tiny(HUGE_VALF, 1));
    for (const auto& [a, b] : {std::pair{"nan.exr", "zero.exr"},
                               {"zero.exr", "nan.exr"},
                               {"inf.exr", "zero.exr"},
                               {"nan.exr", "nan.exr"},
                               {"inf.exr", "inf.exr"},
                               {"zero.exr", "inf.exr"}}) {
        SCOPED_TRACE(std::string(a) + " " + b);
        const RunResult result = lobe({"diff", a, b, "--tolerance", "1e9", "--quiet"});
        EXPECT_EQ(result.code, 8);
        EXPECT_NE(result.err.find("the first at pixel 0,0"), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("--allow-nonfinite"), std::string::npos) << result.err;
    }
    const auto left = diff({"nan.exr", "zero.exr", "--allow-nonfinite", "--tolerance", "0"}, 0);
    EXPECT_EQ(left["verdict"], "same");
    EXPECT_EQ(left["metrics"]["odd_values"]["nan_mismatched"], 3);
    EXPECT_EQ(left["metrics"]["odd_values"]["pixels"], 1);
    EXPECT_EQ(left["metrics"]["compared_pixels"], 1);
    diff({"nan.exr", "zero.exr", "--allow-nonfinite"}, 8);  // not identical, and nothing else said
    EXPECT_EQ(diff({"nan.exr", "nan.exr", "--allow-nonfinite"}, 0)["verdict"], "identical");
    ImageFile bad = tiny(1, 1, true);
    bad.pixels[4] = nan;  // a standard error
    write("bad.exr", bad);
    EXPECT_EQ(lobe({"diff", "bad.exr", "bad.exr"}).code, 8);
}

TEST_F(Diff, RefusesWhatCannotBeCompared) {
    ImageFile shifted = tiny(1, 2), wide = tiny(1, 2), grey = tiny(1, 2);
    shifted.x = 3;
    shifted.full_width = 8;
    wide.height = wide.full_height = 2;
    wide.pixels.resize(12);
    grey.channels = {"Y"};
    grey.pixels.resize(2);
    write("a.exr", tiny(1, 2));
    write("wide.exr", wide);
    write("shifted.exr", shifted);
    write("grey.exr", grey);
    folder_.write("text.exr", "no picture");
    expect_fault(
        lobe({"diff", "a.exr", "wide.exr"}), 3,
        "a.exr: the pictures do not show the same pixels: 2x1 pixels against 2x2 pixels of "
        "wide.exr",
        "--crop");
    expect_fault(lobe({"diff", "shifted.exr", "a.exr"}), 3,
                 "shifted.exr: the pictures do not show the same pixels: 2x1 pixels at 3,0 of 8x1 "
                 "against 2x1 pixels of a.exr",
                 "--crop");
    expect_fault(lobe({"diff", "a.exr", "grey.exr"}), 3,
                 "grey.exr: the picture has no channels R, G, B but Y", "only colour pictures");
    expect_fault(lobe({"diff", "a.exr", "none.exr"}), 3,
                 "none.exr: cannot read the picture: No such file or directory");
    expect_fault(lobe({"diff", "a.exr", "."}), 3, ".: cannot read the picture: Is a directory");
    const RunResult text = lobe({"diff", "text.exr", "a.exr"});
    EXPECT_EQ(text.code, 3);
    EXPECT_EQ(text.err.find("lobe: error: text.exr: cannot read the picture: "), 0u) << text.err;
    EXPECT_EQ(lobe({"diff", "a.exr"}).code, 2);
    EXPECT_EQ(lobe({"diff", "a.exr", "a.exr", "-o", "error.gif"}).code, 2);
    EXPECT_EQ(lobe({"diff", "a.exr", "a.exr", "-o", "none/error.exr"}).code, 5);
}

TEST_F(Diff, ErrorImagesCanBeRead) {
    ImageFile a = tiny(1, 2, true), b = tiny(1, 3.5f, true);
    a.x = b.x = 1;
    a.full_width = b.full_width = 4;
    write("a.exr", a);
    write("b.exr", b);
    lobe({"diff", "a.exr", "b.exr", "-o", "error.exr"});
    const ImageFile map = images_.read(path("error.exr"));
    const auto value = [&](const std::string& name, std::size_t pixel) {
        const auto at = std::find(map.channels.begin(), map.channels.end(), name);
        EXPECT_NE(at, map.channels.end()) << name;
        return map.pixels[pixel * map.channels.size() + std::size_t(at - map.channels.begin())];
    };
    EXPECT_EQ(value("G", 0), 0);
    EXPECT_EQ(value("G", 1), 1.5f);
    EXPECT_EQ(value("Z.B", 0), 0);
    EXPECT_NEAR(value("Z.B", 1), -1.5 / std::sqrt(0.125), 1e-5);
    EXPECT_EQ(map.x, 1u);
    EXPECT_EQ(map.full_width, 4u);
    lobe({"diff", "a.exr", "b.exr", "-o", "error.png"});
    const ImageFile colours = images_.read(path("error.png"));
    ASSERT_TRUE(colours.bytes);
    EXPECT_EQ(colours.pixels[0] + colours.pixels[1] + colours.pixels[2], 0);
    EXPECT_GT(colours.pixels[3], 200);
}

TEST_F(Diff, PngHoldsDisplayValues) {
    render({"-o", "a.exr", "-o", "a.png"});
    const RunResult result = lobe({"diff", "a.png", "a.exr", "--tolerance", "10"});
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.err.find("a.png holds display values"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("a.png has no standard errors: no test"), std::string::npos);
    // Clipped at 1 and rounded to 8 bits: the median pixel is within half a step.
    const auto json = diff({"a.png", "a.exr", "--tolerance", "10"}, 0);
    EXPECT_LT(double(json["metrics"]["channels"]["R"]["absolute_error"]["median"]), 0.004);
    EXPECT_EQ(diff({"a.png", "a.png"}, 0)["verdict"], "identical");
}

TEST_F(Diff, ChanceIsNoDifferenceAndThreePercentIs) {
    render({"-o", "a.exr", "--seed", "1", "--spp", "64"});
    render({"-o", "b.exr", "--seed", "2", "--spp", "64"});
    render({"-o", "short.exr", "--seed", "3", "--spp", "8"});
    const auto same = diff({"a.exr", "b.exr"}, 0);
    EXPECT_EQ(same["verdict"], "same");
    EXPECT_EQ(same["level"], 1e-3);
    EXPECT_GT(double(same["metrics"]["p_same"]), 1e-3);
    EXPECT_EQ(diff({"a.exr", "short.exr"}, 0)["verdict"], "same");
    diff({"a.exr", "b.exr", "--tolerance", "1e-6"}, 8);  // asked for, it alone decides
    write_scene("[20 20 20]", "[20.6 20.6 20.6]");
    write_scene("[.3 .3 .3]", "[.309 .309 .309]");
    render({"-o", "brighter.exr", "--seed", "4", "--spp", "64"});
    const auto differ = diff({"a.exr", "brighter.exr"}, 8);
    EXPECT_EQ(differ["verdict"], "differ");
    EXPECT_LT(double(differ["metrics"]["p_same"]), 1e-6);
    EXPECT_EQ(diff({"a.exr", "brighter.exr", "--tolerance", "10"}, 0)["verdict"], "same");
    diff({"a.exr", "brighter.exr", "--tolerance", "10", "--level", "0.001"}, 8);  // both decide
    const RunResult seeds = lobe({"diff", "a.exr", "a.exr"});
    EXPECT_NE(seeds.err.find("both pictures have seed 1"), std::string::npos);
}
