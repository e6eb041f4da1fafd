// SPDX-License-Identifier: Apache-2.0
// Warps: samples lie in their domain and fill it with the stated density. Frames: orthonormal.
#include <gtest/gtest.h>

#include "support/chi_square.h"
#include "support/oracle.h"
#include "support/probe.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double tests = 6;  // chi-square tests here
constexpr int cells = 16;    // along each of two coordinates that the density makes uniform
constexpr float last = 1 - 0x1p-24f;

class Warp : public testing::Test {
  protected:
    std::vector<float> call(const char* kernel, const std::vector<float>& u, int width) {
        Buffer<float> out(test_device(), u.size() / 2 * width);
        run_probe(program_, kernel, u.size() / 2, Buffer<float>(test_device(), u), out);
        return out.read_all();
    }
    std::vector<float> cone(const std::vector<float>& u, float one_minus_cos) {
        Buffer<float> out(test_device(), u.size() / 2 * 3);
        run_probe(program_, "warp_uniform_cone", u.size() / 2, Buffer<float>(test_device(), u),
                  one_minus_cos, out);
        return out.read_all();
    }
    Program program_ = build_probe("probe/warp.cl");
};

std::vector<float> numbers(std::uint64_t seed, std::size_t count = 2 << 17) {
    Random random(seed);
    std::vector<float> u(count);
    for (float& value : u) value = random.uniform_float();
    return u;
}

const std::vector<float> corner_u = {0, 0, 0, last, last, 0, last, last, .5f, .5f, 0, .5f, .5f, 0};

// Counts points of the unit square, which must be uniform.
class Square {
  public:
    void add(double a, double b) {
        ASSERT_TRUE(a >= -1e-5 && a <= 1 + 1e-5 && b >= -1e-5 && b <= 1 + 1e-5) << a << " " << b;
        const int i = std::clamp(static_cast<int>(a * cells), 0, cells - 1);
        const int j = std::clamp(static_cast<int>(b * cells), 0, cells - 1);
        ++counts_[i * cells + j];
    }
    testing::AssertionResult is_uniform() const {
        return follows(counts_, std::vector<double>(counts_.size(), 1), tests);
    }

  private:
    std::vector<double> counts_ = std::vector<double>(cells * cells);
};

double turns(float x, float y) { return std::atan2(double(y), double(x)) / double(2 * pi) + 0.5; }

}  // namespace

TEST_F(Warp, CosineHemisphere) {
    const auto w = call("warp_cosine_hemisphere", numbers(1), 3);
    Square square;
    for (std::size_t i = 0; i < w.size(); i += 3) {
        ASSERT_NEAR(std::hypot(w[i], w[i + 1], w[i + 2]), 1, 3e-7);
        square.add(1 - double(w[i + 2]) * w[i + 2], turns(w[i], w[i + 1]));
    }
    EXPECT_TRUE(square.is_uniform());
    const auto corners = call("warp_cosine_hemisphere", corner_u, 3);
    for (std::size_t i = 2; i < corners.size(); i += 3) EXPECT_GT(corners[i], 1e-4f);
}

TEST_F(Warp, UniformSphere) {
    const auto w = call("warp_uniform_sphere", numbers(2), 3);
    Square square;
    for (std::size_t i = 0; i < w.size(); i += 3) {
        ASSERT_NEAR(std::hypot(w[i], w[i + 1], w[i + 2]), 1, 3e-7);
        square.add(0.5 + 0.5 * w[i + 2], turns(w[i], w[i + 1]));
    }
    EXPECT_TRUE(square.is_uniform());
    const auto poles = call("warp_uniform_sphere", corner_u, 3);  // u.x is 0, then the last
    EXPECT_EQ(poles[2], 1);
    EXPECT_NEAR(poles[8], -1, 2e-7);
}

TEST_F(Warp, UniformDisk) {
    const auto p = call("warp_uniform_disk", numbers(3), 2);
    Square square;
    for (std::size_t i = 0; i < p.size(); i += 2)
        square.add(double(p[i]) * p[i] + double(p[i + 1]) * p[i + 1], turns(p[i], p[i + 1]));
    EXPECT_TRUE(square.is_uniform());
    for (float value : call("warp_uniform_disk", corner_u, 2)) EXPECT_LE(std::fabs(value), 1);
    for (float value : call("warp_uniform_disk", {.5f - 0x1p-25f, .5f - 0x1p-25f}, 2))
        EXPECT_EQ(value, 0);  // the centre is no 0 / 0
}

TEST_F(Warp, UniformTriangle) {
    const auto b = call("warp_uniform_triangle", numbers(4), 2);
    Square square;
    for (std::size_t i = 0; i < b.size(); i += 2) {
        const double x = b[i], y = b[i + 1], rest = 1 - x - y;
        ASSERT_TRUE(x >= 0 && y >= 0 && rest > -1e-7);
        const double t = (1 - rest) * (1 - rest);  // share of the area beyond this line
        square.add(t, rest < 1 ? x / (1 - rest) : 0);
    }
    EXPECT_TRUE(square.is_uniform());
}

TEST_F(Warp, UniformCone) {
    for (const float one_minus_cos : {0.3f, 5e-9f}) {  // half angles of 46 degrees and 1e-4 rad
        const auto w = cone(numbers(5), one_minus_cos);
        Square square;
        for (std::size_t i = 0; i < w.size(); i += 3) {
            ASSERT_NEAR(std::hypot(w[i], w[i + 1], w[i + 2]), 1, 3e-7);
            const double s2 = double(w[i]) * w[i] + double(w[i + 1]) * w[i + 1];
            square.add(s2 / (1 + std::sqrt(1 - s2)) / one_minus_cos, turns(w[i], w[i + 1]));
        }
        EXPECT_TRUE(square.is_uniform()) << one_minus_cos;
    }
}

// All over the sphere and at both poles, where older constructions break down.
TEST_F(Warp, FrameIsOrthonormal) {
    std::vector<float> n = {0, 0, 1, 0, 0, -1}, v;
    Random random(6);
    for (int i = 0; i < 100000; ++i) {
        const double theta =
            i % 2 ? std::acos(random.uniform(-1, 1)) : double(pi) - random.log_uniform(1e-8, 1);
        const double phi = random.uniform(0, 6.28);
        n.insert(n.end(), {float(std::sin(theta) * std::cos(phi)),
                           float(std::sin(theta) * std::sin(phi)), float(std::cos(theta))});
    }
    for (std::size_t i = 0; i < n.size(); ++i) v.push_back(float(random.uniform(-1, 1)));
    Buffer<float> out(test_device(), 4 * n.size());
    run_probe(program_, "warp_frame", n.size() / 3, Buffer<float>(test_device(), n),
              Buffer<float>(test_device(), v), out);
    const auto got = out.read_all();
    Long worst = 0;
    for (std::size_t i = 0; i < n.size() / 3; ++i) {
        const auto vec = [](const float* p) { return vec3l(p[0], p[1], p[2]); };
        const vec3l normal = glm::normalize(vec(&n[3 * i])), t = vec(&got[12 * i]),
                    b = vec(&got[12 * i + 3]);
        for (const Long error :
             {glm::dot(t, t) - 1, glm::dot(b, b) - 1, glm::dot(t, b), glm::dot(t, normal),
              glm::dot(b, normal), glm::length(glm::cross(t, b) - normal)})
            worst = std::max(worst, std::fabs(error));
        worst = std::max(
            worst, glm::length(vec(&got[12 * i + 9]) - vec(&v[3 * i])) / 4);  // there and back
    }
    std::printf("  frame within %.2Le\n", worst);
    EXPECT_LE(worst, 3e-7L);
}
