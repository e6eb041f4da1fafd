// SPDX-License-Identifier: Apache-2.0
// How far a picture is from another, or from a reference: errors with the known variances taken
// out, errors of pixels, of blocks, and whether chance explains them. FLIP (Andersson and others
// 2020) is not among them: no library of the system provides it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/block_test.h"

namespace lobe {

// One side of a comparison; the arrays belong to the caller. Rows from the top.
struct PictureView {
    std::uint32_t width = 0, height = 0;
    const std::vector<float>* rgb = nullptr;              // 3 a pixel
    const std::vector<float>* standard_error = nullptr;   // 3 a pixel; null or empty: unknown
    const std::vector<float>* luminance_error = nullptr;  // 1 a pixel; null or empty: see below
    double freedom = LOBE_REPLICATES - 1;                 // of each standard error
};

// Of an Estimate, or of anything else whose members have these names.
template <typename Picture>
PictureView view_of(const Picture& p) {
    return {p.width, p.height, &p.rgb, &p.standard_error, &p.luminance_error};
}

struct MetricsOptions {
    const std::vector<bool>* left_out = nullptr;  // pixels not to compare, or null
    std::uint32_t block = 8;                      // pixels a side
    double trim = 1e-3;                           // share of the pixels that trimmed figures drop
};

// Values that are no radiance, over all pixels and channels, those left out too.
struct OddValues {
    std::size_t nan_picture = 0, nan_reference = 0;
    std::size_t inf_picture = 0, inf_reference = 0;
    std::size_t nan_mismatched = 0;  // NaN on one side only
    std::size_t inf_mismatched = 0;  // infinite on one side, or of the other sign
    std::size_t negative_picture = 0, negative_reference = 0;
    std::size_t standard_errors = 0;  // that are NaN, infinite or negative, of either side
    std::size_t pixels = 0;           // with any of these but negative values; never compared
    std::uint32_t first_x = 0, first_y = 0;  // the first of those pixels

    std::size_t nonfinite() const {
        return nan_picture + nan_reference + inf_picture + inf_reference + standard_errors;
    }
};

// Figures of one channel over the pixels compared; I is the picture, R the reference, d = I - R.
// A difference of means squared may come out negative and is given so: clipped, it would be biased.
struct ChannelMetrics {
    std::string name;  // "luminance", "R", "G", "B"

    double picture_mean = 0, reference_mean = 0;
    double mean_difference = 0;  // mean of d, with its sign

    double mse_raw = 0;                        // mean of d^2
    double rmse = 0;                           // its root
    double relative_rmse = 0;                  // rmse / |reference_mean|; 0 where both are 0
    std::optional<double> mse;                 // mse_raw less the mean variance of R, if known
    std::optional<double> mse_standard_error;  // of that, from the spread over pixels
    std::optional<double> bias_squared;        // mse less the mean variance of I, if known
    std::optional<double> bias_squared_standard_error;  // of that, from the spread over pixels
    double mse_trimmed = 0;                             // mse_raw without the pixels of largest d^2
    double mse_trimmed_share = 0;                       // of the sum of d^2, in the dropped pixels

    double relmse_epsilon = 0;        // 1e-2 * reference_mean^2
    double relmse_raw = 0;            // mean of d^2 / (R^2 + relmse_epsilon); 0 / 0 counts as 0
    std::optional<double> relmse;     // the same with R's variance taken from d^2, if known
    double relmse_trimmed = 0;        // relmse_raw without the pixels of largest contribution
    double relmse_trimmed_share = 0;  // of the sum, in the dropped pixels

    double smape = 0;                // mean of 2 |d| / (|I| + |R|), from 0 to 2; 0 / 0 counts as 0
    double mean_absolute_error = 0;  // mean of |d|
    double median = 0, p95 = 0, p99 = 0, max = 0;  // of |d|, interpolated between neighbours
    std::uint32_t max_x = 0, max_y = 0;            // pixel of the largest |d|

    std::size_t blocks = 0;        // with at least one pixel compared
    double block_rmse = 0;         // root of the mean squared difference of block means
    Block worst_block;             // whose means differ most
    std::optional<MeanTest> test;  // where both sides carry standard errors
};

struct PictureMetrics {
    std::size_t pixels = 0;    // compared
    std::size_t left_out = 0;  // by the mask
    OddValues odd;
    std::uint32_t block = 8;  // pixels a side
    std::size_t trimmed = 0;  // pixels that trimmed figures drop: a share of all, rounded up
    // Standard errors of luminance are not in a file of R, G, B: then those of the channels, added,
    // bound them from above, and what is made with them errs on the careful side.
    bool luminance_error_is_bound = false;
    std::vector<ChannelMetrics> channels;  // luminance, R, G, B

    // How likely chance alone makes R, G and B differ so or more, in the image's mean or in some
    // block (see MeanTest::p), for any correlation between channels; where both carry errors.
    std::optional<double> p_same;
};

// Compares two pictures of one size. A picture with no pixel to compare gives zeros and no tests.
// Throws Error (internal) for arrays that do not fit the size.
PictureMetrics compare_pictures(const PictureView& picture, const PictureView& reference,
                                const MetricsOptions& options = {});

}  // namespace lobe
