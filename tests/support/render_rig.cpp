// SPDX-License-Identifier: Apache-2.0
#include "support/render_rig.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/kernel_text.h"
#include "base/statistics.h"
#include "report/estimate.h"
#include "support/chi_square.h"
#include "support/device.h"
#include "support/probe.h"

namespace lobe::test {

namespace {

// The models of all render tests, so that they share one kernel.
const std::set<std::string> render_models = {"lambert", "measured", "modified_phong", "phong",
                                             "rational"};

testing::AssertionResult student(double difference, double error, double freedom, double tests) {
    const double t = error > 0 ? difference / error : difference == 0 ? 0 : INFINITY;
    const double p = 2 * student_cdf(-std::abs(t), std::max(1.0, freedom));
    const double level = sidak(family_alpha, tests);
    auto verdict = p >= level ? testing::AssertionSuccess() : testing::AssertionFailure();
    return verdict << "t = " << t << " with " << freedom << " degrees of freedom, p = " << p
                   << ", level " << level << "; difference " << difference << " +- " << error;
}

}  // namespace

Picture render_picture(const Scene& scene, const PictureOptions& options) {
    PackOptions pack;
    pack.all_features = options.general;
    pack.integrator = options.integrator;
    const KernelText kernels = test_kernels();
    for (const BrdfTable& table : read_brdf_tables(kernels))
        if (render_models.count(table.name)) pack.models.push_back(table);
    const PackedScene packed = pack_scene(scene, pack);
    SessionOptions session_options;
    session_options.double_precision = options.double_precision;
    session_options.local = options.local;
    session_options.abreast = options.abreast;
    Session session(test_device(), kernels, packed, session_options);
    session.set_seed(options.seed);
    RenderPlan plan;
    plan.samples = options.samples;
    plan.tiles_per_launch = options.tiles_per_launch;
    RenderOutcome outcome = render(session, plan);
    Picture picture{std::move(outcome.film), session.status(), session.statistics(), ""};
    picture.hash = image_hash(estimate(picture.film));
    EXPECT_EQ(picture.status.nonfinite(), 0u);
    EXPECT_EQ(picture.status.negative(), 0u);
    EXPECT_EQ(picture.status.trapped(), 0u);
    return picture;
}

MeanOf mean_of(const Picture& picture, int channel, std::optional<Region> region) {
    const Region r = region.value_or(Region{0, 0, picture.film.width(), picture.film.height()});
    const FilmSums sums = picture.film.sums();
    const double pixels = double(r.x1 - r.x0) * (r.y1 - r.y0);
    MeanOf result;
    double variance = 0;
    for (std::uint32_t y = r.y0; y < r.y1; ++y)
        for (std::uint32_t x = r.x0; x < r.x1; ++x) {
            const std::size_t p = std::size_t{y} * picture.film.width() + x;
            std::vector<double> means;
            const double samples = sums.samples[p];
            double total = 0;
            for (unsigned k = 0; k < LOBE_REPLICATES; ++k) {
                const double sum = sums.radiance[(p * LOBE_REPLICATES + k) * 3 + channel];
                total += sum;
                means.push_back(sum / (samples / LOBE_REPLICATES));
            }
            result.mean += total / samples;
            variance += sample_variance(means) / LOBE_REPLICATES;
        }
    result.mean /= pixels;
    result.error = std::sqrt(variance) / pixels;
    result.freedom = pixels * (LOBE_REPLICATES - 1);
    return result;
}

testing::AssertionResult agrees(const MeanOf& mean, double exact, double tests, double slack) {
    return student(mean.mean - exact, std::hypot(mean.error, slack * std::abs(exact)), mean.freedom,
                   tests)
           << " of " << exact;
}

testing::AssertionResult agrees(const MeanOf& a, const MeanOf& b, double tests, double slack) {
    return student(a.mean - b.mean, std::hypot(std::hypot(a.error, b.error), slack * b.mean),
                   std::min(a.freedom, b.freedom), tests)
           << " of " << b.mean;
}

testing::AssertionResult blocks_agree(const Picture& a, const Picture& b, double tests) {
    const std::uint32_t width = a.film.width(), height = a.film.height();
    const double blocks = std::ceil(width / 8.0) * std::ceil(height / 8.0);
    const auto whole = agrees(mean_of(a), mean_of(b), tests * (blocks + 1));
    if (!whole) return whole;
    for (std::uint32_t y = 0; y < height; y += 8)
        for (std::uint32_t x = 0; x < width; x += 8) {
            const Region r{x, y, std::min(x + 8, width), std::min(y + 8, height)};
            auto block = agrees(mean_of(a, 0, r), mean_of(b, 0, r), tests * (blocks + 1));
            if (!block) return block << ", block at " << x << ", " << y;
        }
    return testing::AssertionSuccess();
}

}  // namespace lobe::test
