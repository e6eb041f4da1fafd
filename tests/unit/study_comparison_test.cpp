// SPDX-License-Identifier: Apache-2.0
#include "study/comparison_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "report/metrics.h"

using namespace lobe;

namespace {

Reference grey_reference(std::uint32_t side, float value, float error) {
    Reference reference;
    reference.width = reference.height = side;
    reference.rgb.assign(3 * side * side, value);
    reference.standard_error.assign(3 * side * side, error);
    reference.luminance_error.assign(side * side, error);
    reference.masked.assign(side * side, false);
    return reference;
}

Estimate noisy_picture(std::uint32_t side, double value, double deviation, std::uint64_t seed) {
    Random random(seed);
    Estimate picture;
    picture.width = picture.height = side;
    for (std::uint32_t p = 0; p < side * side; ++p)
        picture.rgb.insert(picture.rgb.end(), 3,
                           static_cast<float>(value + deviation * random.normal()));
    return picture;
}

// A row whose B has `ratio` times the error of A; the noise of both is small.
ComparisonRow row_of(bool equal_time, std::uint32_t samples, double ratio) {
    ComparisonRow row;
    row.equal_time = equal_time;
    row.samples_a = row.samples_b = samples;
    for (int s = 0; s < 20; ++s) {
        const double a = 1e-3 * (1 + 0.01 * (s % 5)), time = 1 + 0.02 * (s % 3);
        row.a.push_back({std::uint64_t(s), samples, time, {a, a / 2, 0.1}});
        row.b.push_back({std::uint64_t(s), samples, time, {ratio * a, ratio * a / 2, 0.1}});
        row.ratios.log_ratios.push_back(std::log(ratio) + 0.002 * (s % 4));
        row.trimmed_ratios.log_ratios.push_back(std::log(ratio) + 0.002 * (s % 4));
    }
    return row;
}

ComparisonReport report_of(const std::vector<double>& ratios) {
    ComparisonReport report;
    for (double ratio : ratios) {
        SceneComparison scene;
        scene.a.scene = scene.b.scene = "a,\"b\".pbrt";
        scene.rows = {row_of(false, 8, 1), row_of(false, 64, 1), row_of(true, 8, 1),
                      row_of(true, 64, ratio)};
        report.scenes.push_back(scene);
    }
    judge_report(report);
    return report;
}

}  // namespace

TEST(PictureError, SubtractsTheReferencesVariance) {
    // Errors .1 of the picture and .05 of the reference about a mean of 2: 4096 pixels.
    Reference reference = grey_reference(64, 2, 0.05f);
    Random random(4);
    for (std::size_t p = 0; p < 4096; ++p)
        for (std::size_t c = 0, noise = 0; c < 3; ++c, ++noise)
            reference.rgb[3 * p + c] =
                c ? reference.rgb[3 * p] : static_cast<float>(2 + 0.05 * random.normal());
    const Estimate picture = noisy_picture(64, 2, 0.1, 5);
    const PictureError error = picture_error(picture, reference, reference.masked);
    EXPECT_NEAR(error.mse, 0.01 / 4, 4 * 0.01 / 4 * std::sqrt(2.0 / 4096) * 1.25);
    EXPECT_NEAR(reference_variance(reference, reference.masked), 0.0025 / 4, 1e-5);
}

// The same figure as the metrics of `lobe diff`, on another scale.
TEST(PictureError, AgreesWithTheMetrics) {
    const Reference reference = grey_reference(64, 2, 0.05f);
    const Estimate picture = noisy_picture(64, 2, 0.1, 6);
    const PictureError error = picture_error(picture, reference, reference.masked);
    const PictureMetrics metrics = compare_pictures(view_of(picture), view_of(reference));
    EXPECT_NEAR(4 * error.mse, *metrics.channels[0].mse, 1e-7);
    EXPECT_NEAR(error.trimmed_share, metrics.channels[0].mse_trimmed_share, 1e-7);
}

TEST(PictureError, TrimsTheWorstPixels) {
    const Reference reference = grey_reference(64, 1, 0);
    Estimate picture = noisy_picture(64, 1, 0.1, 7);
    const PictureError calm = picture_error(picture, reference, reference.masked);
    for (int c = 0; c < 3; ++c) picture.rgb[3 * 1234 + c] = 101;
    const PictureError error = picture_error(picture, reference, reference.masked);
    EXPECT_GT(error.mse, 2);
    EXPECT_NEAR(error.mse_trimmed, calm.mse_trimmed, 0.01 * calm.mse_trimmed);
    EXPECT_GT(error.trimmed_share, 0.98);
    std::vector<bool> masked = reference.masked;
    masked[1234] = true;
    EXPECT_NEAR(picture_error(picture, reference, masked).mse, calm.mse, 0.01 * calm.mse);
    masked.assign(masked.size(), true);
    EXPECT_EQ(picture_error(picture, reference, masked).mse, 0);
}

TEST(Comparison, EvenSamples) {
    for (std::uint32_t good : {2, 4, 6, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40, 48, 56, 64, 448})
        EXPECT_EQ(even_samples(good), good);
    EXPECT_EQ(even_samples(0.1), 2u);
    EXPECT_EQ(even_samples(-3), 2u);
    EXPECT_EQ(even_samples(NAN), 2u);
    EXPECT_EQ(even_samples(18.5), 20u);
    EXPECT_EQ(even_samples(17.5), 16u);
    EXPECT_EQ(even_samples(60), 64u);
    EXPECT_EQ(even_samples(59), 56u);
    EXPECT_EQ(even_samples(1e30), 1u << 30);
    for (double wanted = 2; wanted < 1e6; wanted *= 1.01) {
        EXPECT_LT(std::fabs(std::log(even_samples(wanted) / wanted)), std::log(std::sqrt(2.0)));
        if (wanted > 8) {
            EXPECT_LT(std::fabs(std::log(even_samples(wanted) / wanted)), std::log(1.13));
        }
    }
}

TEST(Comparison, TheSentenceIsOfTheLongestRow) {
    ComparisonReport report = report_of({1.5});
    EXPECT_EQ(headline_row(report), 3u);
    EXPECT_EQ(headline(report).verdict, Verdict::win);
    EXPECT_EQ(verdict_sentence(report).find("At equal time A wins"), 0u);
    report.by_time = false;
    EXPECT_EQ(headline_row(report), 1u);
    EXPECT_EQ(headline(report).verdict, Verdict::tie);
    EXPECT_EQ(verdict_sentence(report).find("At equal samples neither wins"), 0u);
    EXPECT_EQ(verdict_sentence(report_of({0.5})).find("At equal time B wins: A's"), 0u);
    const std::string text = to_text(report_of({0.5}));
    EXPECT_EQ(text.substr(text.size() - verdict_sentence(report_of({0.5})).size() - 1),
              verdict_sentence(report_of({0.5})) + "\n");
}

TEST(Comparison, SeveralScenesAreCombined) {
    const ComparisonReport report = report_of({1.5, 2, 1.0 / 3});
    ASSERT_EQ(report.combined.size(), 4u);
    EXPECT_NEAR(headline(report).ratio, 1.003, 1e-3);
    EXPECT_EQ(headline(report).verdict, Verdict::tie);
    EXPECT_EQ(report.scenes[2].rows[3].judgement.verdict, Verdict::loss);
    const nlohmann::ordered_json json = to_json(report);
    EXPECT_EQ(json["combined"].size(), 4u);
    EXPECT_EQ(json["headline"]["verdict"], "TIE");
    for (const char* key : {"ratio", "lo", "hi", "p", "p_holm", "wilcoxon_p", "seeds", "verdict"})
        EXPECT_TRUE(json["scenes"][1]["rows"][0].contains(key)) << key;
}

TEST(Comparison, CsvHasALineARun) {
    const std::string csv = to_csv(report_of({1.5, 2}));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 4 * 2 * 20);
    EXPECT_NE(csv.find("\n\"a,\"\"b\"\".pbrt\",equal_samples,A,0,8,1,0.001,0.0005,0.1\n"),
              std::string::npos);
}

TEST(Reference, MaskIsWidenedByOnePixel) {
    std::vector<bool> mask(5 * 4);
    mask[0] = mask[2 * 5 + 4] = true;
    const std::vector<bool> wide = widened(mask, 5);
    const std::string rows =
        "XX..."
        "XX.XX"
        "...XX"
        "...XX";
    for (std::size_t p = 0; p < wide.size(); ++p) EXPECT_EQ(wide[p], rows[p] == 'X') << p;
    EXPECT_TRUE(widened({}, 0).empty());
}
