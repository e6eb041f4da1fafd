// SPDX-License-Identifier: Apache-2.0
// Renders scenes made in code, and asks whether the mean of a picture is what it must be.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "render/render.h"
#include "scene/scene.h"

namespace lobe::test {

struct PictureOptions {
    std::uint32_t samples = 64;
    std::uint64_t seed = 1;
    std::array<unsigned, 2> local{8, 8};
    std::uint32_t tiles_per_launch = 0;
    unsigned abreast = 0;  // as in SessionOptions
    bool general = true;   // one kernel for all tests: compiled once
    bool double_precision = false;
    Integrator integrator;
};

struct Picture {
    Film film;
    RenderStatus status;
    RenderStatistics statistics;
    std::string hash;
};

// Packs and renders. Every status counter must be zero, or the running test fails.
Picture render_picture(const Scene& scene, const PictureOptions& options = {});

// A mean with its standard error, `freedom` degrees of freedom behind it.
struct MeanOf {
    double mean = 0, error = 0, freedom = 0;
};

// Of one channel (0, 1, 2) over the pixels of [x0, x1) x [y0, y1), lights included.
struct Region {
    std::uint32_t x0, y0, x1, y1;
};
MeanOf mean_of(const Picture& picture, int channel = 0, std::optional<Region> region = {});

// Fails where the mean is further from `exact` than chance allows in a family of `tests` tests.
// Float arithmetic may add a relative error of `slack`.
testing::AssertionResult agrees(const MeanOf& mean, double exact, double tests,
                                double slack = 2e-6);
testing::AssertionResult agrees(const MeanOf& a, const MeanOf& b, double tests,
                                double slack = 2e-6);

// Compares two pictures of one size by the means of their 8x8 blocks and by the whole.
testing::AssertionResult blocks_agree(const Picture& a, const Picture& b, double tests);

}  // namespace lobe::test
