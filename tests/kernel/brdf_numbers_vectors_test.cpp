// SPDX-License-Identifier: Apache-2.0
// What float makes of lobes when all it has are rounded unit vectors: as printed, and as lobe does
// it. Relative errors against long double for the vectors before they were rounded; the published
// figures, of other samples of inputs, stand beside ours.
#include <gtest/gtest.h>

#include <iterator>

#include "base/random.h"
#include "kernel/brdf_probe.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr std::size_t count = 100000;

vec3l random_direction(Random& random) {
    return glm::normalize(vec3l(random.normal(), random.normal(), random.normal()));
}

void push(std::vector<float>& to, const vec3l& v) {
    for (int k = 0; k < 3; ++k) to.push_back(static_cast<float>(v[k]));
}

// Errors of one way to compute a lobe, and how many values were no light at all, in percent.
struct Way {
    double worst = 0, infinite = 0, negative = 0;
    void see(float value, Long exact, double least) {
        infinite += !std::isfinite(value) ? 100.0 / count : 0;
        negative += value < 0 ? 100.0 / count : 0;
        if (std::isfinite(value) && exact > least)
            worst = std::max(worst, relative_error(value, exact));
    }
};

class BrdfNumbersVectors : public testing::Test {
  protected:
    // Light at angles of 1e-8 to 1.5 from the mirror direction, evenly in the logarithm; the seven
    // ways of the kernel naive_vectors.
    std::vector<Way> ways(double exponent) {
        Random random(71);
        const std::vector<float> n(count, static_cast<float>(exponent));
        std::vector<float> normal, wo, wi;
        std::vector<Long> x;
        while (x.size() < count) {
            const vec3l up = random_direction(random);
            vec3l view = random_direction(random);
            if (glm::dot(up, view) < 0) view = -view;
            const vec3l mirror = 2 * glm::dot(up, view) * up - view;
            const vec3l any = random_direction(random);
            const vec3l aside = glm::normalize(any - glm::dot(any, mirror) * mirror);
            const Long apart = random.log_uniform(1e-8, 1.5);
            x.push_back(2 * std::sin(apart / 2) * std::sin(apart / 2));
            push(normal, up);
            push(wo, view);
            push(wi, std::cos(apart) * mirror + std::sin(apart) * aside);
        }
        Buffer<float> out(test_device(), 7 * count);
        run_probe(program_, "naive_vectors", count, Buffer<float>(test_device(), n),
                  Buffer<float>(test_device(), normal), Buffer<float>(test_device(), wo),
                  Buffer<float>(test_device(), wi), out);
        const auto values = out.read_all();
        std::vector<Way> result(7);
        for (std::size_t i = 0; i < count; ++i) {
            const Long rational = (1 - x[i]) / (1 - x[i] + n[i] * x[i]);
            const Long power = std::exp(n[i] * std::log1p(-x[i]));
            for (int way = 0; way < 7; ++way)
                result[way].see(values[7 * i + way], way < 4 ? rational : power,
                                way < 4 ? 0 : 1e-30);
        }
        return result;
    }

    Program program_ = build_probe("probe/brdf_naive.cl");
};

}  // namespace

// The bound is what rounding one direction by 2^-24 does at an angle d: n d / (1 + n d^2 / 2)
// 2^-24, at most sqrt(n / 2) 2^-24.
TEST_F(BrdfNumbersVectors, RationalLobe) {
    struct {
        double n, printed, infinite, negative, clamped, difference;  // published
    } const rows[] = {{1e2, 2.8e-5, 0, 0, 2.5e-5, 8.7e-7},  {1e3, 3.7e-4, 0, 0, 2.9e-4, 2.7e-6},
                      {1e4, 2.9e-3, 0, 0, 3.0e-3, 9.1e-6},  {1e5, 2.6e-2, 0, 0, 2.3e-2, 2.4e-5},
                      {1e6, .60, 0, 0, .23, 7.1e-5},        {1e7, 2.2, 5.4, .15, 1.5, 2.9e-4},
                      {1e8, 2.2, 34.5, 5.9, 12.9, 8.0e-4},  {1e10, 1.8, 36.7, 5.9, 2.1e3, 8.8e-3},
                      {1e12, 3.0, 42.6, 6.6, 1.8e5, 8.7e-2}};
    std::printf(
        "      n: printed (published), %% inf, %% negative; clamped; difference; through a "
        "frame, bound\n");
    for (const auto& row : rows) {
        const auto way = ways(row.n);
        const double bound = std::sqrt(row.n / 2) * 0x1p-24;
        std::printf(
            "  %5g: %.1e (%.1e) %.2f (%g) %.2f (%g); %.1e (%.1e); %.1e (%.1e); %.1e, %.1e\n", row.n,
            way[0].worst, row.printed, way[0].infinite, row.infinite, way[0].negative, row.negative,
            way[1].worst, row.clamped, way[2].worst, row.difference, way[3].worst, bound);
        EXPECT_NEAR(std::log2(way[0].worst / row.printed), 0, 1) << row.n;
        EXPECT_NEAR(std::log2(way[1].worst / row.clamped), 0, 1.3) << row.n;
        EXPECT_NEAR(std::log2(way[2].worst / row.difference), 0, 1.2) << row.n;
        EXPECT_LE(way[3].worst, 6 * bound) << row.n;
        for (int k = 1; k < 4; ++k) EXPECT_EQ(way[k].infinite + way[k].negative, 0) << row.n;
        // Infinite where the cosine rounds to 1, whatever n from 2^25 on: 36 percent of these.
        EXPECT_NEAR(way[0].infinite, row.n < 1e7 ? 0 : row.n == 1e7 ? 5.4 : 35.9, 1) << row.n;
        EXPECT_NEAR(way[0].negative, row.n < 1e7 ? 0 : row.n == 1e7 ? .35 : 5.9, .5) << row.n;
    }
}

TEST_F(BrdfNumbersVectors, PowerLobe) {
    struct {
        double n, printed, ours;  // published
    } const rows[] = {{1e2, 3.6e-5, 1.8e-5},
                      {1e4, 2.9e-3, 1.2e-4},
                      {1e6, .30, 9.4e-4},
                      {1e7, 10, 3.4e-3},
                      {1e8, 3.4e10, 1.0e-2}};
    std::printf("      n: printed (published), clamped; lobe's through a frame (published)\n");
    for (const auto& row : rows) {
        const auto way = ways(row.n);
        std::printf("  %5g: %.1e (%.1e), %.1e; %.1e (%.1e)\n", row.n, way[4].worst, row.printed,
                    way[5].worst, way[6].worst, row.ours);
        EXPECT_NEAR(std::log2(way[6].worst / row.ours), 0, 1.3) << row.n;
        if (row.n < 1e8)
            EXPECT_NEAR(std::log2(way[4].worst / row.printed), 0, 1.1) << row.n;
        else  // (1 + 1 ulp)^n instead of nearly nothing, and no clamp helps
            EXPECT_GT(std::min(way[4].worst, way[5].worst), 1e9) << row.n;
        EXPECT_EQ(way[6].infinite + way[6].negative, 0) << row.n;
    }
}

// pow of a cosine below 0 is a second lobe or no number; of 1 + 1 ulp it is 1.5e5.
TEST_F(BrdfNumbersVectors, PowersOfCosinesThatAreNone) {
    const std::vector<float> n = {10, 2.5f, 1e8f}, up = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    const float sine = std::sqrt(0.99f);
    const std::vector<float> wo = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    const std::vector<float> wi = {sine, 0, -0.1f, sine, 0, -0.1f, 0, 0, 1 + 0x1p-23f};
    Buffer<float> out(test_device(), 21);
    run_probe(program_, "naive_vectors", 3, Buffer<float>(test_device(), n),
              Buffer<float>(test_device(), up), Buffer<float>(test_device(), wo),
              Buffer<float>(test_device(), wi), out);
    const auto got = out.read_all();
    EXPECT_NEAR(got[4], 1e-10, 1e-15);
    EXPECT_TRUE(std::isnan(got[7 + 4]));
    EXPECT_NEAR(got[14 + 4] / 1.5e5, 1, 0.01);
    EXPECT_LT(got[14], 0);  // the rational lobe as printed: negative light
    for (int i = 0; i < 2; ++i) EXPECT_EQ(got[7 * i + 6], 0);
    EXPECT_LE(got[14 + 6], 1);
    EXPECT_LE(got[14 + 3], 1);
}

// A sample's density, as it is carried and as it is found again for the direction that went to the
// world and came back, relative.
TEST_F(BrdfNumbersVectors, DensitiesThereAndBack) {
    struct {
        double n, printed, bad, ours;  // published worst errors, percent infinite or negative
    } const rows[] = {{1e3, 3e-4, 0, 2.0e-6}, {1e6, .37, 0, 6.3e-5}, {1e8, 3.95, 6.5, 4.9e-4}};
    std::printf("      n: printed (published) %% bad (published); lobe's (published)\n");
    for (const auto& row : rows) {
        Random random(72);
        const std::vector<float> n(count, static_cast<float>(row.n));
        std::vector<float> normal, wo, u;
        for (std::size_t i = 0; i < count; ++i) {
            push(normal, random_direction(random));
            push(wo, direction(std::acos(Long(random.uniform(.05, 1))), random.uniform(0, 6.28)));
            for (int k = 0; k < 3; ++k) u.push_back(random.uniform_float());
        }
        Buffer<float> out(test_device(), 3 * count);
        run_probe(program_, "naive_return", count, Buffer<float>(test_device(), n),
                  Buffer<float>(test_device(), normal), Buffer<float>(test_device(), wo),
                  Buffer<float>(test_device(), u), out);
        const auto got = out.read_all();
        double printed = 0, bad = 0, ours = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const float carried = got[3 * i], naive = got[3 * i + 1];
            if (!(carried > 0)) continue;
            if (!std::isfinite(naive) || naive < 0)
                bad += 100.0 / count;
            else
                printed = std::max(printed, relative_error(naive, carried));
            ours = std::max(ours, relative_error(got[3 * i + 2], carried));
        }
        std::printf("  %5g: %.1e (%.1e) %.1f (%g); %.1e (%.1e)\n", row.n, printed, row.printed, bad,
                    row.bad, ours, row.ours);
        EXPECT_NEAR(std::log2(printed / row.printed), 0, 0.6) << row.n;
        EXPECT_NEAR(bad, row.bad, 1.5) << row.n;
        EXPECT_NEAR(std::log2(ours / row.ours), 0, 2) << row.n;
    }
}

// Tangents of a frame about a normal 1e-3 rad from the pole where an older construction breaks.
TEST_F(BrdfNumbersVectors, FramesAtThePole) {
    Random random(73);
    std::vector<float> normal;
    for (std::size_t i = 0; i < count; ++i)
        push(normal, direction(pi - 1e-3L, random.uniform(0, 6.28)));
    Buffer<float> out(test_device(), 6 * count);
    run_probe(program_, "naive_frame", count, Buffer<float>(test_device(), normal), out);
    const auto got = out.read_all();
    double worst = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const vec3l t(got[6 * i], got[6 * i + 1], got[6 * i + 2]);
        const vec3l b(got[6 * i + 3], got[6 * i + 4], got[6 * i + 5]);
        for (const Long error : {glm::dot(t, t) - 1, glm::dot(b, b) - 1, glm::dot(t, b)})
            worst = std::max(worst, double(std::fabs(error)));
    }
    std::printf("  off by %.1e (published .2); lobe's frames are within 3e-7\n", worst);
    EXPECT_NEAR(worst, .2, .1);
}
