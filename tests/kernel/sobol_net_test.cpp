// SPDX-License-Identifier: Apache-2.0
// The low-discrepancy pairs: Sobol's own points, and after scrambling still a (0, 2)-sequence.
#include <gtest/gtest.h>

#include <bitset>
#include <cmath>

#include "support/chi_square.h"
#include "support/probe.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

struct Pair {
    std::uint32_t x, y;  // fractions of 2^32
};

// Sobol's first two dimensions by their direction numbers: the first is van der Corput's, the
// second has the primitive polynomial x + 1, so v(k) = v(k-1) xor v(k-1) / 2.
Pair sobol_by_directions(std::uint32_t point) {
    Pair p{0, 0};
    std::uint32_t vx = 1u << 31, vy = 1u << 31;
    for (; point; point >>= 1) {
        if (point & 1) p.x ^= vx, p.y ^= vy;
        vx >>= 1;
        vy ^= vy >> 1;
    }
    return p;
}

std::vector<Pair> read_pairs(const Buffer<cl_uint>& out) {
    const std::vector<cl_uint> words = out.read_all();
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < words.size(); i += 2) pairs.push_back({words[i], words[i + 1]});
    return pairs;
}

std::vector<Pair> scrambled(const Program& program, std::uint32_t key_x, std::uint32_t key_y,
                            std::uint32_t dimension, std::uint32_t first, std::uint32_t count) {
    std::vector<cl_uint> in;
    for (std::uint32_t i = 0; i < count; ++i)
        in.insert(in.end(), {key_x, key_y, dimension, first + i});
    Buffer<cl_uint> out(test_device(), 2 * std::size_t{count});
    run_probe(program, "rng_scrambled_sobol", count, Buffer<cl_uint>(test_device(), in), out);
    return read_pairs(out);
}

// Whether of 2^m points every elementary interval of area 2^-m holds exactly one.
bool is_net(const std::vector<Pair>& points) {
    const int m = int(std::lround(std::log2(points.size())));
    for (int a = 0; a <= m; ++a) {
        std::vector<bool> taken(points.size());
        for (const Pair& p : points) {
            const std::uint32_t column = a == 0 ? 0 : p.x >> (32 - a);
            const std::uint32_t row = a == m ? 0 : p.y >> (32 - (m - a));
            const std::size_t cell = (std::size_t{column} << (m - a)) | row;
            if (taken[cell]) return false;
            taken[cell] = true;
        }
    }
    return true;
}

}  // namespace

TEST(SobolNet, PointsAreSobols) {
    Random random(1);
    std::vector<cl_uint> points;
    for (cl_uint i = 0; i < 4096; ++i) points.push_back(i);
    for (int i = 0; i < 4096; ++i) points.push_back(random.word());
    Buffer<cl_uint> out(test_device(), 2 * points.size());
    run_probe(build_probe("probe/rng.cl"), "rng_plain_sobol", points.size(),
              Buffer<cl_uint>(test_device(), points), out);
    const std::vector<Pair> pairs = read_pairs(out);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Pair expected = sobol_by_directions(points[i]);
        ASSERT_EQ(pairs[i].x, expected.x) << "point " << points[i];
        ASSERT_EQ(pairs[i].y, expected.y) << "point " << points[i];
    }
}

// Every aligned run of 2^m points of every scrambled pair is a net: prefixes and later runs.
TEST(SobolNet, ScrambledRunsAreNets) {
    const Program program = build_probe("probe/rng.cl");
    Random random(2);
    for (int i = 0; i < 24; ++i) {
        const std::uint32_t key_x = random.word(), key_y = random.word();
        const std::uint32_t dimension = random.below(200);
        const std::uint32_t start = i % 2 ? random.below(1000) * 4096 : 0;
        const auto points = scrambled(program, key_x, key_y, dimension, start, 4096);
        for (std::uint32_t size = 1; size <= 4096; size *= 2) {
            ASSERT_TRUE(is_net({points.begin(), points.begin() + size}))
                << size << " points of pair " << dimension << " from " << start;
            ASSERT_TRUE(is_net({points.end() - size, points.end()}));
        }
    }
}

// The scramble is not a mere shift or exclusive or: nets of different keys are different sets.
TEST(SobolNet, KeysAndDimensionsGiveOtherNets) {
    const Program program = build_probe("probe/rng.cl");
    const auto a = scrambled(program, 1, 2, 3, 0, 256);
    for (const auto& b : {scrambled(program, 2, 2, 3, 0, 256), scrambled(program, 1, 3, 3, 0, 256),
                          scrambled(program, 1, 2, 4, 0, 256)}) {
        std::size_t same = 0;
        double flips[2][32] = {};
        for (std::size_t i = 0; i < a.size(); ++i) {
            same += a[i].x == b[i].x || a[i].y == b[i].y;
            const std::bitset<32> dx(a[i].x ^ b[i].x), dy(a[i].y ^ b[i].y);
            for (int bit = 0; bit < 32; ++bit) flips[0][bit] += dx[bit], flips[1][bit] += dy[bit];
        }
        EXPECT_LE(same, 2u);
        for (int axis = 0; axis < 2; ++axis)
            for (int bit = 0; bit < 24; ++bit)
                EXPECT_TRUE(normal_deviate((flips[axis][bit] - 128) / 8, 1e3)) << "bit " << bit;
    }
}

// The first point of a pair, over many pixels, is uniform: what one sample per pixel sees.
TEST(SobolNet, FirstPointsAreUniform) {
    const Program program = build_probe("probe/rng.cl");
    Random random(4);
    std::vector<cl_uint> in;
    constexpr std::uint32_t count = 1 << 18;
    for (std::uint32_t i = 0; i < count; ++i)
        in.insert(in.end(), {random.word(), random.word(), 5, 0});
    Buffer<cl_uint> out(test_device(), 2 * std::size_t{count});
    run_probe(program, "rng_scrambled_sobol", count, Buffer<cl_uint>(test_device(), in), out);
    std::vector<double> cells(64 * 64);
    for (const Pair& p : read_pairs(out)) ++cells[64 * (p.x >> 26) + (p.y >> 26)];
    EXPECT_TRUE(follows(cells, std::vector<double>(cells.size(), 1), 1));
}

// What the nets are for: the error of an integral falls faster than with random numbers.
TEST(SobolNet, IntegratesBetterThanChance) {
    const Program program = build_probe("probe/rng.cl");
    double squared = 0;
    for (std::uint32_t pixel = 0; pixel < 64; ++pixel) {
        double sum = 0;
        for (const Pair& p : scrambled(program, 77 * pixel, pixel, 2, 0, 256))
            sum += std::sin(3.0 * p.x / 4294967296.0) * p.y / 4294967296.0;
        const double exact = (1 - std::cos(3.0)) / 3 * 0.5;
        squared += std::pow(sum / 256 - exact, 2);
    }
    // Chance: variance .0813 / 256, that is a root mean square of 0.0178.
    EXPECT_LT(std::sqrt(squared / 64), 0.0178 / 8);
}
