// SPDX-License-Identifier: Apache-2.0
// The choices of the path tracer: other noise, the same picture.
#include <cmath>

#include "cli.h"

using namespace lobe::test;

namespace {

class IntegratorOptions : public Cli {};

}  // namespace

TEST_F(IntegratorOptions, ChangeTheNoiseOnly) {
    const std::vector<std::string> usual = {"-o", "out.exr", "--spp", "256"};
    const auto picture = render(usual);
    const double mean = picture["error"]["mean"];
    const auto half_interval = [](const auto& json) {
        return (double(json["error"]["mean_ci95"][1]) - double(json["error"]["mean_ci95"][0])) / 2;
    };
    const std::vector<std::vector<std::string>> choices = {{"--sampler", "independent"},
                                                           {"--strategy", "light"},
                                                           {"--strategy", "brdf"},
                                                           {"--heuristic", "balance"},
                                                           {"--directions", "cosine"}};
    for (const auto& choice : choices) {
        std::vector<std::string> arguments = usual;
        arguments.insert(arguments.end(), choice.begin(), choice.end());
        const auto other = render(arguments);
        EXPECT_NE(other["image_hash"], picture["image_hash"]) << joined(choice);
        EXPECT_LT(std::abs(double(other["error"]["mean"]) - mean),
                  2 * std::hypot(half_interval(other), half_interval(picture)))
            << joined(choice);
    }
}

TEST_F(IntegratorOptions, UnknownChoicesAreRefused) {
    for (const char* option : {"--sampler", "--strategy", "--heuristic", "--directions"}) {
        const RunResult result = lobe({"render", "scene.pbrt", option, "none-such"});
        EXPECT_EQ(result.code, 2) << option;
        EXPECT_NE(result.err.find("none-such"), std::string::npos) << result.err;
    }
}
