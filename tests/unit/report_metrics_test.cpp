// SPDX-License-Identifier: Apache-2.0
// Error metrics against figures worked out by hand and against a plain long double oracle.
#include "report/metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "base/statistics.h"
#include "report/error_map.h"
#include "report/metrics_report.h"

using namespace lobe;

namespace {

struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgb, standard_error, luminance_error;
};

Picture grey(std::uint32_t width, std::uint32_t height, const std::vector<float>& values,
             const std::vector<float>& errors = {}) {
    Picture p{width, height, {}, {}, errors};
    for (const float v : values) p.rgb.insert(p.rgb.end(), 3, v);
    for (const float e : errors) p.standard_error.insert(p.standard_error.end(), 3, e);
    return p;
}

// Positive, over many orders of magnitude, with errors or without.
Picture random_picture(std::uint32_t width, std::uint32_t height, bool errors, Random& random) {
    Picture p{width, height, {}, {}, {}};
    for (std::size_t i = 0; i < 3 * std::size_t(width) * height; ++i) {
        p.rgb.push_back(static_cast<float>(random.log_uniform(1e-4, 1e3)));
        if (errors) p.standard_error.push_back(static_cast<float>(random.uniform() * p.rgb.back()));
    }
    if (errors)
        for (std::size_t i = 0; i < std::size_t(width) * height; ++i)
            p.luminance_error.push_back(static_cast<float>(random.uniform()));
    return p;
}

PictureMetrics metrics(const Picture& a, const Picture& b, const MetricsOptions& options = {}) {
    return compare_pictures(view_of(a), view_of(b), options);
}

const ChannelMetrics& channel(const PictureMetrics& m, const std::string& name) {
    return *std::find_if(m.channels.begin(), m.channels.end(),
                         [&](const ChannelMetrics& c) { return c.name == name; });
}

// The figures as their definitions have them, one pixel after the other.
struct Oracle {
    long double mse_raw = 0, mse = 0, bias = 0, relmse = 0, relmse_raw = 0, smape = 0, mae = 0,
                mean_i = 0, mean_r = 0, block_sum = 0, mse_trimmed = 0;
    std::vector<long double> size;

    Oracle(const Picture& a, const Picture& b, int c, const std::vector<bool>& out) {
        const long double w[] = {0.2126L, 0.7152L, 0.0722L};
        const auto value = [&](const std::vector<float>& v, std::size_t p) -> long double {
            if (c >= 0) return v[3 * p + c];
            return w[0] * v[3 * p] + w[1] * v[3 * p + 1] + w[2] * v[3 * p + 2];
        };
        const auto variance = [&](const Picture& x, std::size_t p) -> long double {
            const long double s = c < 0 ? x.luminance_error[p] : x.standard_error[3 * p + c];
            return s * s;
        };
        std::vector<std::size_t> kept;
        for (std::size_t p = 0; p < out.size(); ++p)
            if (!out[p]) kept.push_back(p);
        const long double n = kept.size();
        for (const std::size_t p : kept) {
            mean_i += value(a.rgb, p) / n;
            mean_r += value(b.rgb, p) / n;
        }
        const long double epsilon = 0.01L * mean_r * mean_r;
        for (const std::size_t p : kept) {
            const long double i = value(a.rgb, p), r = value(b.rgb, p), d = i - r;
            size.push_back(std::fabs(d));
            mse_raw += d * d / n;
            mse += (d * d - variance(b, p)) / n;
            bias += (d * d - variance(b, p) - variance(a, p)) / n;
            relmse_raw += d * d / (r * r + epsilon) / n;
            relmse += (d * d - variance(b, p)) / (r * r + epsilon) / n;
            smape += 2 * std::fabs(d) / (std::fabs(i) + std::fabs(r)) / n;
            mae += std::fabs(d) / n;
        }
        std::sort(size.begin(), size.end());
        const std::size_t drop = (kept.size() + 999) / 1000;
        for (std::size_t k = 0; k + drop < size.size(); ++k)
            mse_trimmed += size[k] * size[k] / static_cast<long double>(size.size() - drop);
        for (std::uint32_t y = 0; y < a.height; y += 8)
            for (std::uint32_t x = 0; x < a.width; x += 8) {
                long double sum = 0, count = 0;
                for (std::uint32_t v = y; v < std::min(y + 8, a.height); ++v)
                    for (std::uint32_t u = x; u < std::min(x + 8, a.width); ++u) {
                        const std::size_t p = std::size_t(v) * a.width + u;
                        if (out[p]) continue;
                        sum += value(a.rgb, p) - value(b.rgb, p);
                        count += 1;
                    }
                if (count > 0) block_sum += sum * sum / count / n;
            }
    }
};

void expect_close(double found, long double wanted, const char* what) {
    EXPECT_NEAR(found, double(wanted), 1e-9 * std::fabs(double(wanted))) << what;
}

}  // namespace

// I = 1 2 3 4, R = 1 1 5 4: d = 0 1 -2 0. Variances of R .25 each, of I .5 each.
TEST(ReportMetrics, FiguresByHand) {
    const float half = 0.5f, root = std::sqrt(0.5f);
    const Picture i = grey(2, 2, {1, 2, 3, 4}, {root, root, root, root});
    const Picture r = grey(2, 2, {1, 1, 5, 4}, {half, half, half, half});
    const PictureMetrics m = metrics(i, r);
    EXPECT_EQ(m.pixels, 4u);
    EXPECT_EQ(m.trimmed, 1u);
    EXPECT_FALSE(m.luminance_error_is_bound);
    ASSERT_EQ(m.channels.size(), 4u);
    for (const ChannelMetrics& c : m.channels) {
        SCOPED_TRACE(c.name);
        EXPECT_NEAR(c.picture_mean, 2.5, 1e-12);
        EXPECT_NEAR(c.reference_mean, 2.75, 1e-12);
        EXPECT_NEAR(c.mean_difference, -0.25, 1e-12);
        EXPECT_NEAR(c.mse_raw, 1.25, 1e-12);
        EXPECT_NEAR(c.rmse, std::sqrt(1.25), 1e-12);
        EXPECT_NEAR(c.relative_rmse, std::sqrt(1.25) / 2.75, 1e-12);
        EXPECT_NEAR(*c.mse, 1.0, 1e-12);
        EXPECT_NEAR(*c.bias_squared, 0.5, 1e-7);
        // Squares 0 1 4 0: their sample variance is (1.5625 + .0625 + 7.5625 + 1.5625) / 3.
        EXPECT_NEAR(*c.mse_standard_error, std::sqrt(10.75 / 3 / 4), 1e-12);
        EXPECT_NEAR(*c.bias_squared_standard_error, std::sqrt(10.75 / 3 / 4), 1e-7);
        EXPECT_NEAR(c.mse_trimmed, 1.0 / 3, 1e-12);
        EXPECT_NEAR(c.mse_trimmed_share, 0.8, 1e-12);
        const double epsilon = 0.01 * 2.75 * 2.75;
        EXPECT_NEAR(c.relmse_epsilon, epsilon, 1e-12);
        const double first = 1 / (1 + epsilon), second = 4 / (25 + epsilon);
        EXPECT_NEAR(c.relmse_raw, (first + second) / 4, 1e-12);
        EXPECT_NEAR(c.relmse_trimmed, second / 3, 1e-12);
        EXPECT_NEAR(c.relmse_trimmed_share, first / (first + second), 1e-12);
        EXPECT_NEAR(c.smape, (2.0 / 3 + 4.0 / 8) / 4, 1e-12);
        EXPECT_NEAR(c.mean_absolute_error, 0.75, 1e-12);
        EXPECT_NEAR(c.median, 0.5, 1e-12);  // of 0 0 1 2
        EXPECT_NEAR(c.p95, 1.85, 1e-12);    // .95 * 3 = 2.85
        EXPECT_NEAR(c.p99, 1.97, 1e-12);
        EXPECT_NEAR(c.max, 2, 1e-12);
        EXPECT_EQ(c.max_x, 0u);
        EXPECT_EQ(c.max_y, 1u);
        EXPECT_EQ(c.blocks, 1u);
        EXPECT_NEAR(c.block_rmse, 0.25, 1e-12);
        EXPECT_NEAR(c.worst_block.difference, -0.25, 1e-12);
        EXPECT_EQ(c.worst_block.width, 2u);
        ASSERT_TRUE(c.test);
        // Variance of the sum 4 (.25 + .5) = 3, of the mean 3 / 16; Welch's degrees from squares
        // 4 (1/16 + 1/4) / (1 + 2).
        EXPECT_NEAR(c.test->image.standard_error, std::sqrt(3.0) / 4, 1e-7);
        EXPECT_NEAR(c.test->image.freedom, 9 / (1.25 / 3) - 2, 1e-5);
        EXPECT_NEAR(c.test->image.t, -1 / std::sqrt(3.0), 1e-5);
        EXPECT_NEAR(c.test->image.p, 2 * student_cdf(-1 / std::sqrt(3.0), c.test->image.freedom),
                    1e-5);
        EXPECT_NEAR(c.test->blocks_p, c.test->image.p, 1e-12);  // one block, the whole image
        EXPECT_NEAR(c.test->chi_square_p, c.test->image.p, 1e-6);
        EXPECT_EQ(c.test->p, 1);
    }
    ASSERT_TRUE(m.p_same);
    EXPECT_EQ(*m.p_same, 1);
}

TEST(ReportMetrics, AgreesWithItsOracle) {
    Random random(1);
    for (const auto& [width, height] : {std::pair{1u, 1u}, {5u, 3u}, {8u, 8u}, {61u, 37u}}) {
        const Picture a = random_picture(width, height, true, random);
        const Picture b = random_picture(width, height, true, random);
        std::vector<bool> out(std::size_t(width) * height);
        for (std::size_t p = 1; p < out.size(); ++p) out[p] = random.uniform() < 0.2;
        MetricsOptions options;
        options.left_out = &out;
        const PictureMetrics m = metrics(a, b, options);
        EXPECT_EQ(m.left_out, std::size_t(std::count(out.begin(), out.end(), true)));
        EXPECT_EQ(m.pixels + m.left_out, out.size());
        for (int k = -1; k < 3; ++k) {
            const ChannelMetrics& c = m.channels[std::size_t(k + 1)];
            SCOPED_TRACE(c.name + " of " + std::to_string(width) + "x" + std::to_string(height));
            const Oracle o(a, b, k, out);
            expect_close(c.picture_mean, o.mean_i, "mean of I");
            expect_close(c.reference_mean, o.mean_r, "mean of R");
            expect_close(c.mse_raw, o.mse_raw, "MSE");
            EXPECT_NEAR(*c.mse, double(o.mse), 1e-9 * double(o.mse_raw));
            EXPECT_NEAR(*c.bias_squared, double(o.bias), 1e-9 * double(o.mse_raw));
            expect_close(c.relmse_raw, o.relmse_raw, "relMSE");
            EXPECT_NEAR(*c.relmse, double(o.relmse), 1e-9 * double(o.relmse_raw));
            expect_close(c.smape, o.smape, "SMAPE");
            expect_close(c.mean_absolute_error, o.mae, "mean absolute error");
            expect_close(c.mse_trimmed, o.mse_trimmed, "trimmed MSE");
            expect_close(c.max, o.size.back(), "largest");
            expect_close(c.block_rmse, std::sqrt(o.block_sum), "blocks");
            const long double at = 0.99L * (o.size.size() - 1);
            const auto low = std::size_t(at);
            const long double next = o.size[std::min(low + 1, o.size.size() - 1)];
            expect_close(c.p99, o.size[low] + (at - low) * (next - o.size[low]), "99 %");
        }
    }
}

// Where only the picture has errors, or none has, what would need them stays unknown.
TEST(ReportMetrics, UnknownErrorsStayUnknown) {
    Random random(2);
    const Picture with = random_picture(9, 9, true, random);
    const Picture without = random_picture(9, 9, false, random);
    const Picture other = random_picture(9, 9, false, random);
    for (const Picture* a : {&with, &without}) {
        const PictureMetrics m = metrics(*a, other);
        EXPECT_FALSE(m.p_same);
        for (const ChannelMetrics& c : m.channels) {
            EXPECT_FALSE(c.mse || c.mse_standard_error || c.bias_squared || c.relmse || c.test);
            EXPECT_GT(c.mse_raw, 0);
        }
    }
    const PictureMetrics m = metrics(without, with);
    for (const ChannelMetrics& c : m.channels) {
        EXPECT_TRUE(c.mse && c.mse_standard_error && c.relmse);
        EXPECT_FALSE(c.bias_squared || c.test);
    }
    EXPECT_NE(to_text(m, "A", "B").find("MSE less variance of B"), std::string::npos);
    EXPECT_EQ(to_text(metrics(with, without), "A", "B").find("unknown"), std::string::npos);
}

// Without its own, the error of luminance is bounded by those of the channels.
TEST(ReportMetrics, LuminanceErrorIsBounded) {
    Random random(3);
    Picture a = random_picture(4, 4, true, random), b = random_picture(4, 4, true, random);
    a.luminance_error.clear();
    b.luminance_error.clear();
    const PictureMetrics m = metrics(a, b);
    EXPECT_TRUE(m.luminance_error_is_bound);
    double variance = 0;
    for (std::size_t i = 0; i < 48; i += 3) {
        const float* s = &b.standard_error[i];
        variance += std::pow(0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2], 2) / 16;
    }
    const ChannelMetrics& c = channel(m, "luminance");
    EXPECT_NEAR(c.mse_raw - *c.mse, variance, 1e-9 * c.mse_raw);
}

TEST(ReportMetrics, OddValuesAreCountedAndNeverCompared) {
    const float nan = std::nanf(""), inf = HUGE_VALF;
    Picture a = grey(4, 2, {1, 1, 1, 1, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1, 1, 1});
    Picture b = a;
    a.rgb[3 * 2 + 1] = nan;  // against 1
    a.rgb[3 * 3] = b.rgb[3 * 3] = nan;
    a.rgb[3 * 4] = inf;
    b.rgb[3 * 4] = -inf;
    a.rgb[3 * 5] = b.rgb[3 * 5] = inf;
    a.rgb[3 * 6] = -3;  // negative values are compared
    b.standard_error[3 * 7 + 2] = nan;
    b.luminance_error[0] = -1;
    const PictureMetrics m = metrics(a, b);
    EXPECT_EQ(m.odd.nan_picture, 2u);
    EXPECT_EQ(m.odd.nan_reference, 1u);
    EXPECT_EQ(m.odd.nan_mismatched, 1u);
    EXPECT_EQ(m.odd.inf_picture, 2u);
    EXPECT_EQ(m.odd.inf_reference, 2u);
    EXPECT_EQ(m.odd.inf_mismatched, 1u);
    EXPECT_EQ(m.odd.standard_errors, 2u);
    EXPECT_EQ(m.odd.negative_picture, 1u);
    EXPECT_EQ(m.odd.negative_reference, 1u);
    EXPECT_EQ(m.odd.pixels, 6u);
    EXPECT_EQ(m.odd.nonfinite(), 9u);
    EXPECT_EQ(m.odd.first_x, 0u);
    EXPECT_EQ(m.pixels, 2u);
    EXPECT_NEAR(channel(m, "R").mse_raw, 8, 1e-12);  // of 1 against 1 and -3 against 1
    EXPECT_NEAR(channel(m, "G").mse_raw, 0, 1e-12);
    // A mask hides no NaN from the counts.
    const std::vector<bool> all(8, true);
    MetricsOptions options;
    options.left_out = &all;
    const PictureMetrics none = metrics(a, b, options);
    EXPECT_EQ(none.odd.pixels, 6u);
    EXPECT_EQ(none.pixels, 0u);
    EXPECT_FALSE(none.p_same);
    EXPECT_EQ(none.channels.size(), 4u);
}

TEST(ReportMetrics, BlackAndHugeNeedNoCare) {
    const Picture black = grey(3, 3, std::vector<float>(9, 0), std::vector<float>(9, 0));
    const PictureMetrics same = metrics(black, black);
    EXPECT_EQ(*same.p_same, 1);
    for (const ChannelMetrics& c : same.channels) {
        EXPECT_EQ(c.relmse_raw + c.smape + c.relative_rmse + c.mse_trimmed_share, 0);
        EXPECT_EQ(c.test->chi_square_p, 1);
    }
    const Picture huge = grey(3, 3, std::vector<float>(9, 3e38f), std::vector<float>(9, 1e38f));
    const PictureMetrics far = metrics(huge, black);
    EXPECT_NEAR(channel(far, "R").rmse / 3e38, 1, 1e-6);
    EXPECT_TRUE(std::isfinite(channel(far, "R").mse_raw));
    EXPECT_EQ(
        *metrics(grey(3, 3, std::vector<float>(9, 1), std::vector<float>(9, 0)), black).p_same,
        0);  // no error, yet another value
}

TEST(ReportMetrics, UnlikeSizesAreAFault) {
    Random random(4);
    const Picture a = random_picture(4, 4, false, random), b = random_picture(4, 5, false, random);
    EXPECT_THROW(metrics(a, b), Error);
    const std::vector<bool> mask(3);
    MetricsOptions options;
    options.left_out = &mask;
    EXPECT_THROW(metrics(a, a, options), Error);
}

TEST(ReportMetrics, JsonHasEveryChannelAndNull) {
    Random random(5);
    const Picture a = random_picture(9, 9, false, random), b = random_picture(9, 9, true, random);
    const auto json = nlohmann::json::parse(to_json(metrics(a, b)).dump());
    EXPECT_TRUE(json["p_same"].is_null());
    for (const char* name : {"luminance", "R", "G", "B"}) {
        EXPECT_TRUE(json["channels"][name]["mse"].is_number());
        EXPECT_TRUE(json["channels"][name]["bias_squared"].is_null());
        EXPECT_TRUE(json["channels"][name]["test"].is_null());
    }
    const auto tested = nlohmann::json::parse(to_json(metrics(b, b)).dump());
    EXPECT_EQ(tested["p_same"], 1);
    EXPECT_EQ(tested["channels"]["G"]["test"]["worst_block"]["width"], 8);
}

TEST(ReportErrorMap, ShowsDifferencesAndDeviates) {
    Picture a = grey(2, 1, {1, 4}, {3, 0}), b = grey(2, 1, {2, 4}, {4, 0});
    const ImageFile map = absolute_error_picture(view_of(a), view_of(b));
    const std::vector<float> wanted = {1, 1, 1, -0.2f, -0.2f, -0.2f, 0, 0, 0, 0, 0, 0};
    EXPECT_EQ(map.pixels, wanted);
    EXPECT_EQ(map.channels.size(), 6u);
    a.standard_error.clear();
    EXPECT_EQ(absolute_error_picture(view_of(a), view_of(b)).channels.size(), 3u);
    a.rgb[0] = std::nanf("");
    EXPECT_TRUE(std::isnan(absolute_error_picture(view_of(a), view_of(b)).pixels[0]));
    const ImageFile colours = false_colour_error(view_of(a), view_of(b));
    EXPECT_EQ(colours.pixels, (std::vector<float>{0, 255, 0, 0, 0, 0}));
    const Picture far = grey(2, 1, {400, 4.4f});
    const ImageFile far_colours = false_colour_error(view_of(far), view_of(b));
    EXPECT_EQ(far_colours.pixels[0], 255);
    EXPECT_EQ(far_colours.pixels[2], 255);
    EXPECT_GT(far_colours.pixels[3], far_colours.pixels[5]);  // 10 %: red
    EXPECT_LT(far_colours.pixels[3], 255);
}
