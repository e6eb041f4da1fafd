// SPDX-License-Identifier: Apache-2.0
// Does chance explain the difference of two pictures? Tests of the image's mean and of the means of
// its blocks. A pixel's own standard error comes from K replicates and has K - 1 degrees of
// freedom, with K = 2 a single one: no test of a single pixel is worth making. Sums over pixels
// have many.
#pragma once

#include <cstdint>
#include <vector>

#include "shared/frame.h"

namespace lobe {

// One channel of two pictures, over the pixels compared.
struct ChannelPair {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint32_t> place;  // index of each pixel in the picture
    std::vector<double> picture, reference;
    std::vector<double> picture_variance, reference_variance;  // empty where unknown
    double picture_freedom = LOBE_REPLICATES - 1, reference_freedom = LOBE_REPLICATES - 1;

    bool has_errors() const { return !picture_variance.empty() && !reference_variance.empty(); }
};

// A difference of means in a test.
struct Deviation {
    double difference = 0;      // mean of picture - reference
    double standard_error = 0;  // of it; in a block, a side that shows too little noise for what
                                // the other shows is given the other's, scaled by all noise of each
    double freedom = 0;  // of the standard error: Satterthwaite's number of degrees, as Welch
                         // (1947) estimates it from estimated variances
    double t = 0;        // difference, less what rounding can do, over its standard error
    double p = 1;        // that chance alone gives such a |t| or a greater one, Student's
};

struct Block {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;  // pixels
    std::size_t pixels = 0;                             // of them compared
    double difference = 0;                              // of the means, picture - reference
};

struct BlockTest {
    Block block;
    Deviation deviation;
};

struct MeanTest {
    Deviation image;  // of the image's mean
    std::size_t blocks = 0;
    BlockTest worst;          // block of least p
    double blocks_p = 1;      // of the worst block among so many: 1 - (1 - p)^blocks (Sidak)
    double chi_square = 0;    // sum over blocks of the squared normal deviate as likely as t
    double chi_square_p = 1;  // of that, with a degree of freedom a block; a hint, not in p: in
                              // many blocks it sees how far t is from Student's law
    double p = 1;  // of both, each with half of the level: twice the lesser one, at most 1
};

// Blocks of `side` pixels from the top left corner, row by row, those with pixels to compare; what
// sticks out is cut. Without the variances of both sides every deviation keeps only its difference.
std::vector<BlockTest> test_blocks(const ChannelPair& pair, std::uint32_t side);

// Needs the variances of both sides.
MeanTest test_means(const ChannelPair& pair, const std::vector<BlockTest>& blocks);

// The p of the least likely of several tests: 1 - (1 - p)^tests, accurate for small p.
double sidak_p(double p, double tests);

}  // namespace lobe
