// SPDX-License-Identifier: Apache-2.0
// The laboratory's report on stiff and extreme cases: that its reference is one, that its figures
// are those of theory where there is one, and that it can fail.
#include <gtest/gtest.h>

#include "base/kernel_text.h"
#include "base/random.h"
#include "kernel/brdf_probe.h"
#include "lab/check/extremes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

BrdfTable table_of(const KernelText& kernels, const std::string& model) {
    const std::string file = "brdf/" + model + ".h";
    return parse_brdf_table(file, kernels.read(file));
}

// f cos theta_i of the three lobes of Phong's kind, kd = 0 and ks = 1, in long double.
Long oracle(const std::string& model, Long n, const vec3l& wo, const vec3l& wi) {
    const vec3l d = vec3l(-wo.x, -wo.y, wo.z) - wi;
    const Long x = glm::dot(d, d) / 2;
    if (!(x < 1)) return 0;
    const Long t = x < 0.5L ? 1 - x : -wo.x * wi.x - wo.y * wi.y + wo.z * wi.z;
    if (model == "rational") return t / (t + n * x) * wi.z;
    const Long power = std::exp(n * (x < 0.5L ? std::log1p(-x) : std::log(t)));
    return model == "phong" ? power : power * wi.z;
}

const ExtremesRow& row_at(const ExtremesReport& report, const std::string& directions,
                          const std::string& changed, double value) {
    for (const ExtremesBlock& block : report.blocks)
        if (block.directions == directions && block.changed == changed)
            for (const ExtremesRow& row : block.rows)
                if (row.value == static_cast<float>(value)) return row;
    throw std::runtime_error("no such row");
}

const char* const near_mirror = "near the mirror direction";

}  // namespace

// The double build, which everything is measured against, against long double: 1e-12 and more where
// double's own rounding of the inputs' difference is magnified.
TEST(LabExtremes, ReferenceIsOne) {
    LOBE_NEEDS_DOUBLE();
    std::vector<StiffPair> pairs = near_mirror_pairs(4000, 91);
    for (const StiffPair& pair : grazing_pairs(4000, 92)) pairs.push_back(pair);
    std::vector<vec3l> wo, wi;
    for (const StiffPair& pair : pairs) {
        wo.push_back(vec3l(pair.wo));
        wi.push_back(vec3l(pair.wi));
    }
    for (const char* model : {"rational", "modified_phong", "phong"}) {
        const ModelProbe<double> probe(model);
        for (const double n :
             {0.0, 1e-30, .05, 1 - 0x1p-24, 1.0, 1 + 0x1p-23, 10.0, 1e4, 1e8, 1e12}) {
            const auto out = probe.eval({{{"kd", 0}, {"ks", 1}, {"n", n}}}, wo, wi);
            double worst = 0;
            for (std::size_t i = 0; i < out.size(); ++i) {
                const Long exact = oracle(model, static_cast<float>(n), wo[i], wi[i]);
                worst = std::max(worst, double(std::fabs(out[i].f.x - exact)) /
                                            std::max(double(exact), FormErrors::least_value));
            }
            EXPECT_LE(worst, 1e-11) << model << " n " << n;
        }
    }
}

// Rounding the directions changes the rational lobe by n d / (1 + n d^2 / 2) 2^-24 at an angle d,
// at most sqrt(n / 2) 2^-24; both directions are rounded, in two coordinates across.
TEST(LabExtremes, LimitIsTheKnownConditioning) {
    LOBE_NEEDS_DOUBLE();
    const KernelText kernels;
    BrdfProbe single(test_device(), kernels, table_of(kernels, "rational"));
    BrdfProbe twice(test_device(), kernels, table_of(kernels, "rational"), Precision::twice);
    const std::vector<double> ns = {1e4, 1e6, 1e8, 1e10, 1e12};
    std::vector<BrdfRows> sets;
    for (const double n : ns)
        sets.push_back(brdf_rows(single.model(), {{"kd", 0}, {"ks", 1}, {"n", n}}));
    const auto rows = measure_extremes({single, &twice, {}}, sets, near_mirror_pairs(4000, 93));
    for (std::size_t i = 0; i < ns.size(); ++i) {
        const double known = std::sqrt(ns[i] / 2) * 0x1p-24;
        EXPECT_GT(rows[i].limit, 0.6 * known) << ns[i];
        EXPECT_LT(rows[i].limit, 2 * known) << ns[i];
        EXPECT_LT(rows[i].ours.worst, 2 * known) << ns[i];
    }
}

// n = 1e8: 8e-4 from vectors at the most, of which float's arithmetic adds next to nothing, where
// the printed formula is infinite for a third of the directions and more.
TEST(LabExtremes, RationalAtAHundredMillion) {
    LOBE_NEEDS_DOUBLE();
    const KernelText kernels;
    const ExtremesReport report =
        report_extremes(test_device(), kernels, set_up(table_of(kernels, "rational"), {}));
    EXPECT_TRUE(report.passed());
    const ExtremesRow& row = row_at(report, near_mirror, "kd 0", 1e8);
    EXPECT_LE(row.ours.worst, 8e-4);
    EXPECT_GT(row.ours.worst, 1e-4);
    EXPECT_LE(row.arithmetic, 2e-6);
    EXPECT_EQ(row.ours.nonfinite + row.ours.negative, 0u);
    ASSERT_TRUE(row.naive);
    EXPECT_GT(row.naive->nonfinite, report.pairs * 34 / 100);
    EXPECT_GT(row.naive->negative, report.pairs / 200);
    // What it does at n = infinity is no number at all; lobe's is the diffuse part.
    EXPECT_EQ(row_at(report, near_mirror, "", INFINITY).naive->nonfinite, report.pairs);
    EXPECT_LE(row_at(report, near_mirror, "", INFINITY).ours.worst, 1e-6);
    // The blocks that are shown: where directions matter most, for each kind.
    ASSERT_EQ(report.telling().size(), 2u);
    EXPECT_EQ(report.telling()[0]->changed, "kd 0");
}

// A model whose own function is the printed formula fails by its own name, and one that is merely
// imprecise too.
TEST(LabExtremes, PrintedFormulasFail) {
    LOBE_NEEDS_DOUBLE();
    const auto with = [](const std::string& eval) {
        KernelText kernels;
        std::string text = kernels.read("brdf/rational.h");
        const std::string end = "rational_value(m, rational_point(m, wo, wi), wi.z);";
        const auto at = text.find(end);
        EXPECT_NE(at, std::string::npos);
        text.replace(at, end.size(), eval);
        kernels.add("brdf/rational.h", text);
        return report_extremes(test_device(), kernels, set_up(table_of(kernels, "rational"), {}),
                               500);
    };
    const ExtremesReport printed = with(
        "(m->kd + m->ks * (dot(reflect_local(wo), wi) /"
        " (m->n - (m->n - 1) * dot(reflect_local(wo), wi)))) * wi.z;");
    EXPECT_FALSE(printed.passed());
    EXPECT_GT(row_at(printed, near_mirror, "", 1e8).ours.nonfinite, 100u);
    const ExtremesReport coarse = with(
        "rational_value(m, rational_point(m, wo, wi), wi.z) * (LOBE_DOUBLE ? 1 : R(1.00005));");
    EXPECT_FALSE(coarse.passed());
    EXPECT_GT(row_at(coarse, near_mirror, "", 1).excess, 1);
    EXPECT_FALSE(with("LOBE_DOUBLE ? (real3)(NAN) : (real3)(wi.z);").passed());
    EXPECT_TRUE(with("rational_value(m, rational_point(m, wo, wi), wi.z);").passed());
}

TEST(LabExtremes, StiffValues) {
    BrdfParameter p{BrdfParameterKind::number, "n", 100, 0, INFINITY, {}, ""};
    std::vector<double> values = stiff_values(p);
    for (const double v : {0.0, 1e-30, 1e-6, .05, .5, 1 - 0x1p-24, 1.0, 1 + 0x1p-23, 2.0, 10.0, 1e5,
                           1e12, 3e38, double(INFINITY)})
        EXPECT_EQ(std::count(values.begin(), values.end(), double(static_cast<float>(v))), 1) << v;
    p.lowest = 0.1;
    p.highest = 10;
    values = stiff_values(p);
    EXPECT_EQ(values.front(), double(0.1f));
    EXPECT_EQ(values.back(), 10);
    for (const double v : {1 - 0x1p-24, 1.0, 1 + 0x1p-23, 100.0})
        EXPECT_EQ(std::count(values.begin(), values.end(), v), v < 100 ? 1 : 0) << v;
}

TEST(LabExtremes, DirectionsReachWhatTheySay) {
    double least = 1, most = 0, wo_least = 1, wi_least = 1;
    for (const StiffPair& p : near_mirror_pairs(2000, 1)) {
        const double apart = glm::length(glm::dvec3(-p.wo.x, -p.wo.y, p.wo.z) - p.wi);
        least = std::min(least, apart);
        most = std::max(most, apart);
        EXPECT_NEAR(glm::length(p.wo) + glm::length(p.wi), 2, 1e-14);
    }
    EXPECT_LT(least, 1.1e-8);
    EXPECT_GT(most, 1.2);
    for (const StiffPair& p : grazing_pairs(2000, 1)) {
        EXPECT_GT(static_cast<float>(p.wo.z), 0);
        EXPECT_GT(static_cast<float>(p.wi.z), 0);
        wo_least = std::min(wo_least, p.wo.z);
        wi_least = std::min(wi_least, p.wi.z);
    }
    EXPECT_LT(wo_least, 2e-38);
    EXPECT_LT(wi_least, 2e-38);
}
