// SPDX-License-Identifier: Apache-2.0
// The hash and the unit interval: known answers, ranges, independence of neighbouring addresses.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/random.h"
#include "build/features.h"
#include "shared/frame.h"
#include "support/chi_square.h"
#include "support/probe.h"

using namespace lobe;
using namespace lobe::test;

namespace {

using Words = std::array<std::uint32_t, 4>;

// pcg4d as its authors print it (Jarzynski, Olano, JCGT 9(3), 2020, listing 5), written anew.
Words published_pcg4d(Words v) {
    for (std::uint32_t& word : v) word = word * 1664525u + 1013904223u;
    const auto feed = [&] {
        v[0] += v[1] * v[3];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
        v[3] += v[1] * v[2];
    };
    feed();
    for (std::uint32_t& word : v) word ^= word >> 16;
    feed();
    return v;
}

struct Address {
    std::uint32_t pixel, sample, dimension;
};

// Two numbers of a low-discrepancy pair and one hashed number for each address.
std::vector<std::array<double, 3>> numbers(const Program& program,
                                           const std::vector<Address>& addresses,
                                           std::uint64_t seed = 1) {
    std::vector<cl_uint> in;
    for (const Address& a : addresses) in.insert(in.end(), {a.pixel, a.sample, a.dimension, 0});
    Buffer<float> out(test_device(), 3 * addresses.size());
    run_probe(program, "rng_numbers", addresses.size(), cl_uint(seed), cl_uint(seed >> 32),
              Buffer<cl_uint>(test_device(), in), out);
    const std::vector<float> raw = out.read_all();
    std::vector<std::array<double, 3>> values;
    for (std::size_t i = 0; i < addresses.size(); ++i)
        values.push_back({raw[3 * i], raw[3 * i + 1], raw[3 * i + 2]});
    return values;
}

// Deviate of the correlation of two uniform variables from zero.
double correlation_z(const std::vector<std::array<double, 3>>& a,
                     const std::vector<std::array<double, 3>>& b, int ka, int kb) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i][ka] - 0.5) * (b[i][kb] - 0.5);
    return sum * 12 / std::sqrt(double(a.size()));
}

// The probe with hashed numbers in place of Sobol's.
Program independent_probe() {
    Integrator integrator;
    integrator.sampler = Integrator::Sampler::independent;
    return build_probe("probe/rng.cl",
                       {{"lobe_scene.h", scene_header(all_features(), {}, integrator)}});
}

// Means and the correlations between neighbours: pixels, dimensions, samples (which alternate
// between replicates), seeds.
void expect_independent_neighbours(const Program& program) {
    constexpr std::uint32_t count = 1 << 18;
    const auto along = [&](const std::function<Address(std::uint32_t)>& address,
                           std::uint64_t seed = 1) {
        std::vector<Address> all;
        for (std::uint32_t i = 0; i < count; ++i) all.push_back(address(i));
        return numbers(program, all, seed);
    };
    const auto base = along([](std::uint32_t i) { return Address{i, 0, 3}; });
    const std::vector<std::pair<const char*, std::vector<std::array<double, 3>>>> others = {
        {"next pixel", along([](std::uint32_t i) {
             return Address{i + 1, 0, 3};
         })},
        {"pixel below", along([](std::uint32_t i) {
             return Address{i + 640, 0, 3};
         })},
        {"next dimension", along([](std::uint32_t i) {
             return Address{i, 0, 4};
         })},
        {"same use, next bounce", along([](std::uint32_t i) {
             return Address{i, 0, 7};
         })},
        {"other replicate", along([](std::uint32_t i) {
             return Address{i, 1, 3};
         })},
        {"next seed", along(
                          [](std::uint32_t i) {
                              return Address{i, 0, 3};
                          },
                          2)},
        {"seed's upper word", along(
                                  [](std::uint32_t i) {
                                      return Address{i, 0, 3};
                                  },
                                  0x100000001)},
    };
    const double tests = 3 + 9.0 * others.size() + 3;
    for (int k = 0; k < 3; ++k) {
        double sum = 0;
        for (const auto& v : base) sum += v[k] - 0.5;
        EXPECT_TRUE(normal_deviate(sum / std::sqrt(count / 12.0), tests)) << "mean of " << k;
        for (const auto& [name, other] : others)
            for (int m = 0; m < 3; ++m)
                EXPECT_TRUE(normal_deviate(correlation_z(base, other, k, m), tests))
                    << name << ", numbers " << k << " and " << m;
        // Within one address the two of a pair and the hashed one are independent as well.
        EXPECT_TRUE(normal_deviate(correlation_z(base, base, k, (k + 1) % 3), tests));
    }
}

}  // namespace

// Eight samples side by side have the numbers that each has alone.
TEST(RngHash, LanesChangeNothing) {
    Random random(5);
    std::vector<Address> addresses;
    for (int i = 0; i < 4096; ++i)
        addresses.push_back({unsigned(random.uniform() * 4e9), unsigned(random.uniform() * 1e6),
                             unsigned(random.uniform() * 64)});
    for (const auto sampler : {Integrator::Sampler::sobol, Integrator::Sampler::independent}) {
        Integrator integrator;
        integrator.sampler = sampler;
        const auto probe = [&](unsigned abreast) {
            return build_probe(
                "probe/rng.cl",
                {{"lobe_scene.h", scene_header(all_features(), {}, integrator, abreast)}});
        };
        EXPECT_EQ(numbers(probe(1), addresses, 77), numbers(probe(8), addresses, 77));
    }
}

TEST(RngHash, Pcg4dIsAsPublished) {
    Random random(1);
    std::vector<cl_uint> in = {0, 0, 0, 0, ~0u, ~0u, ~0u, ~0u, 1, 2, 3, 4};
    while (in.size() < 4 * 4096) in.push_back(random.word());
    Buffer<cl_uint> out(test_device(), in.size());
    run_probe(build_probe("probe/rng.cl"), "rng_pcg4d", in.size() / 4,
              Buffer<cl_uint>(test_device(), in), out);
    const std::vector<cl_uint> words = out.read_all();
    for (std::size_t i = 0; i < in.size(); i += 4) {
        const Words expected = published_pcg4d({in[i], in[i + 1], in[i + 2], in[i + 3]});
        for (int k = 0; k < 4; ++k) ASSERT_EQ(words[i + k], expected[k]) << "of word " << i;
    }
}

TEST(RngHash, UnitIntervalIsExactAndBelowOne) {
    std::vector<cl_uint> bits = {0, 255, 256, 0x7fffffff, 0x80000000, 0xffffff00, ~0u};
    for (cl_uint i = 0; i < 4096; ++i) bits.push_back(~0u - i);
    Buffer<float> out(test_device(), bits.size());
    run_probe(build_probe("probe/rng.cl"), "rng_unit_interval", bits.size(),
              Buffer<cl_uint>(test_device(), bits), out);
    const std::vector<float> values = out.read_all();
    for (std::size_t i = 0; i < bits.size(); ++i) {
        EXPECT_EQ(values[i], std::ldexp(float(bits[i] >> 8), -24));
        EXPECT_LT(values[i], 1);
    }
}

TEST(RngHash, NeighboursAreIndependent) {
    expect_independent_neighbours(build_probe("probe/rng.cl"));
    expect_independent_neighbours(independent_probe());
}

// Where no pair of numbers is Sobol's, neither are the samples of one replicate stratified: 64 of
// them in 64 cells leave a part of exp(-1) of the cells empty, where Sobol leaves none.
TEST(RngHash, IndependentSamplesOfAReplicateAreNotStratified) {
    constexpr std::uint32_t pixels = 1 << 12, points = 64;
    std::vector<Address> all;
    for (std::uint32_t i = 0; i < pixels * points; ++i)
        all.push_back({i / points, LOBE_REPLICATES * (i % points), 5});
    const auto empty_cells = [&](const Program& program) {
        const auto values = numbers(program, all);
        double empty = 0;
        for (std::uint32_t p = 0; p < pixels; ++p) {
            std::array<int, points> cells{};
            for (std::uint32_t i = p * points; i < (p + 1) * points; ++i)
                ++cells[8 * int(8 * values[i][0]) + int(8 * values[i][1])];
            empty += std::count(cells.begin(), cells.end(), 0);
        }
        return empty / pixels;
    };
    EXPECT_EQ(empty_cells(build_probe("probe/rng.cl")), 0);
    // Exact mean and variance of the number of empty cells.
    const double n = points, q = std::pow(1 - 1 / n, n), both = std::pow(1 - 2 / n, n);
    const double deviation = std::sqrt((n * q + n * (n - 1) * both - n * n * q * q) / pixels);
    EXPECT_TRUE(normal_deviate((empty_cells(independent_probe()) - n * q) / deviation, 1));
}

// Joint distribution of a number with its neighbour's over a grid: not only the correlation.
TEST(RngHash, PairsOfPixelsFillTheSquare) {
    const Program program = build_probe("probe/rng.cl");
    constexpr std::uint32_t count = 1 << 19;
    std::vector<Address> all;
    for (std::uint32_t i = 0; i <= count; ++i) all.push_back({i, 5, 9});
    const auto values = numbers(program, all);
    for (int k = 0; k < 3; ++k) {
        std::vector<double> cells(32 * 32);
        for (std::uint32_t i = 0; i < count; i += 2)
            ++cells[32 * int(32 * values[i][k]) + int(32 * values[i + 1][k])];
        EXPECT_TRUE(follows(cells, std::vector<double>(cells.size(), 1), 3)) << "number " << k;
    }
}
