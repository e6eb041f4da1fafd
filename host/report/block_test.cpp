// SPDX-License-Identifier: Apache-2.0
#include "report/block_test.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"

namespace lobe {
namespace {

// Sum of the variances of one side over some pixels, and what its degrees of freedom need.
struct Noise {
    double variance = 0, weighted_squares = 0;

    void add(double v, double freedom) {
        variance += v;
        weighted_squares += v * v / (freedom + 2);
    }
};

// What the sums over some pixels need to become a Deviation.
struct Sums {
    std::size_t pixels = 0;
    double difference = 0, size = 0;  // of I - R and of |I| + |R|
    Noise picture, reference;

    void add(const ChannelPair& pair, std::size_t i) {
        ++pixels;
        difference += pair.picture[i] - pair.reference[i];
        size += std::fabs(pair.picture[i]) + std::fabs(pair.reference[i]);
        if (!pair.has_errors()) return;
        picture.add(pair.picture_variance[i], pair.picture_freedom);
        reference.add(pair.reference_variance[i], pair.reference_freedom);
    }
};

Sums all_pixels(const ChannelPair& pair) {
    Sums all;
    for (std::size_t i = 0; i < pair.place.size(); ++i) all.add(pair, i);
    return all;
}

// A short render may have missed in a block what is rare there, and then knows no noise. Two
// renders of one scene are noisy in the same places: a side that claims less than half of the noise
// that the other side shows there, in proportion to all noise of each, is given the other's.
// `ratio` is all noise of the picture over that of the reference.
Noise sum_of_noise(const Noise& picture, const Noise& reference, double ratio) {
    double of_picture = 1, of_reference = 1;  // how often each counts
    if (ratio > 0 && std::isfinite(ratio)) {
        if (2 * picture.variance < ratio * reference.variance) {
            of_picture = 0;
            of_reference += ratio;
        } else if (2 * reference.variance < picture.variance / ratio) {
            of_reference = 0;
            of_picture += 1 / ratio;
        }
    }
    return {of_picture * picture.variance + of_reference * reference.variance,
            of_picture * of_picture * picture.weighted_squares +
                of_reference * of_reference * reference.weighted_squares};
}

// Float sums of constant samples differ in their last bits with the number of samples, and alike in
// all pixels: so much of a difference says nothing.
constexpr double rounding = 0x1p-21;

Deviation deviation_of(const Sums& sums, bool has_errors, double ratio) {
    Deviation d;
    if (sums.pixels == 0) return d;
    const auto pixels = static_cast<double>(sums.pixels);
    d.difference = sums.difference / pixels;
    if (!has_errors) return d;
    const Noise noise = sum_of_noise(sums.picture, sums.reference, ratio);
    d.standard_error = std::sqrt(noise.variance) / pixels;
    d.freedom = noise.weighted_squares > 0
                    ? noise.variance * noise.variance / noise.weighted_squares - 2
                    : INFINITY;
    const double excess = std::fabs(sums.difference) - rounding * 0.5 * sums.size;
    if (!(excess > 0)) return d;
    d.t = std::copysign(excess / std::sqrt(noise.variance), sums.difference);
    d.p = std::min(1.0, 2 * student_cdf(-std::fabs(d.t), d.freedom));
    return d;
}

bool less_likely(const BlockTest& a, const BlockTest& b) {
    if (a.deviation.p != b.deviation.p) return a.deviation.p < b.deviation.p;
    return std::fabs(a.deviation.t) > std::fabs(b.deviation.t);  // where both p are 0
}

}  // namespace

std::vector<BlockTest> test_blocks(const ChannelPair& pair, std::uint32_t side) {
    const std::uint32_t columns = (pair.width + side - 1) / side;
    const std::uint32_t rows = (pair.height + side - 1) / side;
    std::vector<Sums> sums(std::size_t(columns) * rows);
    for (std::size_t i = 0; i < pair.place.size(); ++i) {
        const std::uint32_t x = pair.place[i] % pair.width, y = pair.place[i] / pair.width;
        sums[std::size_t(y / side) * columns + x / side].add(pair, i);
    }
    const Sums all = all_pixels(pair);
    const double ratio = all.picture.variance / all.reference.variance;
    std::vector<BlockTest> blocks;
    for (std::size_t b = 0; b < sums.size(); ++b) {
        if (sums[b].pixels == 0) continue;
        BlockTest test;
        test.block.x = static_cast<std::uint32_t>(b % columns) * side;
        test.block.y = static_cast<std::uint32_t>(b / columns) * side;
        test.block.width = std::min(side, pair.width - test.block.x);
        test.block.height = std::min(side, pair.height - test.block.y);
        test.block.pixels = sums[b].pixels;
        test.deviation = deviation_of(sums[b], pair.has_errors(), ratio);
        test.block.difference = test.deviation.difference;
        blocks.push_back(test);
    }
    return blocks;
}

MeanTest test_means(const ChannelPair& pair, const std::vector<BlockTest>& blocks) {
    MeanTest test;
    test.image = deviation_of(all_pixels(pair), pair.has_errors(), 0);
    test.blocks = blocks.size();
    if (blocks.empty()) return test;
    test.worst = *std::min_element(blocks.begin(), blocks.end(), less_likely);
    const auto count = static_cast<double>(blocks.size());
    test.blocks_p = sidak_p(test.worst.deviation.p, count);
    for (const BlockTest& b : blocks) {
        const double z = normal_quantile(0.5 * b.deviation.p);
        test.chi_square += z * z;
    }
    test.chi_square_p = chi_square_survival(test.chi_square, count);
    test.p = std::min(1.0, 2 * std::min(test.image.p, test.blocks_p));
    return test;
}

double sidak_p(double p, double tests) { return -std::expm1(tests * std::log1p(-p)); }

}  // namespace lobe
