// SPDX-License-Identifier: Apache-2.0
// The list of values and limits that implementations of these lobes are known to get wrong, and the
// tests that hold each; those that no other file holds are here.
//
//  1 value 1 at the peak, whatever n          BrdfLobe.Corners
//  2 no light for c <= 0; c^0 is 0 there      BrdfLobe.Corners
//  3 n = 0: constant down to c = 1e-38        BrdfLobe.Corners
//  4 n = 1: the cosine                        BrdfLobe.Corners
//  5 half at c = n / (n + 1)                  BrdfLobe.Corners
//  6 x = 1 / n for large n                    BrdfLobe.Corners
//  7 both ways round                          BrdfSymmetry.*
//  8 vectors that are not quite unit vectors  BrdfNumbersItems.VectorsOffByAMillionth
//  9 pairs 1e-8 to 1e-2 apart                 BrdfNumbersItems.PairsOfAllSeparations
// 10 n = infinity is a mirror                 BrdfExtremes.InfiniteSharpnessIsAMirror;
//    negative n and NaN are refused           Materials.ParametersOutOfRangeSayTheirRange,
//                                             Syntax.RefusesNumbersThatAreNotFinite (unit)
// 11 J and K, and no steps about n = 1        BrdfLobe.MomentsKnownValues, MomentsAgainstQuadrature
// 12 the proxy's ends and middle              BrdfNumbersFloat.ProxyAtItsEnds (lobe inverts
// exactly) 13 points of the exact inverse              BrdfLobe.InverseKnownValues 14 first and
// last random number             BrdfNumbersItems.FirstNumberIsThePeak, BrdfExtremes.* 15 densities
// integrate to 1, chi-square     BrdfSampling.* 16 weight = area of the lobe, ks, cosine
// BrdfNumbersItems.WeightsOfLobesAlone 17 frames at both poles Warp.FrameIsOrthonormal,
//                                             BrdfNumbersVectors.FramesAtThePole
// 18 grazing light                            BrdfNumbersItems.GrazingLight
// 19 albedos at 90 degrees                    BrdfNumbersAlbedo.AtTheHorizon
// 20 furnace                                  BrdfAlbedo.FurnaceTable, BrdfFurnace.* (render)
// 21 Phong's light side multiplies            BrdfNumbersAlbedo.PhongSeenFromTheLight
// 22 cos^n below one, and where it underflows BrdfLobe.Corners
// 23 weights of two strategies                Math.PowerHeuristicExtremesGiveAWeight,
//                                             BrdfNumbersItems.DensitiesWhoseSquareOverflows
// 24 ks = kd = 0                              BrdfExtremes.*
// 25 light from below                         DirectLight.Distant (render), BrdfExtremes.*
// 26 |c| at n = 0 is Lambert                  BrdfAlbedo.RationalClosedForms
// 27 the listing's reading                    BrdfAlbedo.Listing
// 28 relaxed arithmetic                       BrdfNumbersItems.RelaxedArithmetic*
// 29 cones of tiny lights                     LightSampling.SphereConesOfAllWidths
// 30 lobes below the geometric horizon        BrdfStiff.LobesBelowTheSurface (render)
#include <gtest/gtest.h>

#include <regex>

#include "base/files.h"
#include "base/kernel_text.h"
#include "base/random.h"
#include "kernel/brdf_numbers.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const double ns[] = {0, 1e-30, .1, 1 - 0x1p-24, 1, 1 + 0x1p-23, 10, 1e3, 1e6, 1e8, 1e12, 3e38};
const char* const models[] = {"rational", "modified_phong", "phong"};

double area_of(const std::string& model, double n) {  // of a lobe of peak 1, 1/sr away
    const double a = n - 1;
    const double j = n == 0              ? 1
                     : std::fabs(a) < .1 ? .5 - a / 6 + a * a / 12 - a * a * a / 20
                                         : (n * std::log(n) - a) / (a * a);
    return 2 * static_cast<double>(pi) * (model == "rational" ? j : 1 / (n + 1));
}

}  // namespace

TEST(BrdfNumbersItems, VectorsOffByAMillionth) {
    Random random(81);
    std::vector<vec3l> wo, wi;
    const vec3l up(0, 0, 1);
    for (int i = 0; i < 4096; ++i) {
        const vec3l o = direction(std::acos(Long(random.uniform(.01, 1))), random.uniform(0, 6.28));
        const Long off = i % 3 == 0 ? 1e-6L : i % 3 == 1 ? -1e-6L : 0;
        wo.push_back(i == 0 ? up : o * (1 + off));
        wi.push_back(i == 0 ? up * (1 + 0x1p-23L) : vec3l(-o.x, -o.y, o.z) * (1 - off));
    }
    for (const char* model : models) {
        const ModelProbe<float> probe(model);
        for (const double n : ns) {
            const auto out = probe.eval({{{"kd", 0}, {"ks", 1}, {"n", n}}}, wo, wi);
            for (std::size_t i = 0; i < out.size(); ++i) {
                const double cosine = model == std::string("phong") ? 1 : double(wi[i].z);
                ASSERT_TRUE(out[i].f.x >= 0 && out[i].f.x <= cosine * (1 + 2e-7))
                    << model << " n " << n << ": " << out[i].f.x / cosine;
            }
        }
    }
}

// Float's value for rounded vectors against the one for the vectors: 4 sqrt(n / 2) 2^-24, four
// times what the rounding of one of them may do, and four units of the last place.
TEST(BrdfNumbersItems, PairsOfAllSeparations) {
    Random random(82);
    std::vector<vec3l> wo, wi;
    std::vector<Long> x;
    while (wo.size() < 20000) {
        const vec3l o = direction(std::acos(Long(random.uniform(.05, 1))), random.uniform(0, 6.28));
        const vec3l mirror(-o.x, -o.y, o.z);
        const vec3l any = glm::normalize(vec3l(random.normal(), random.normal(), random.normal()));
        const Long apart = random.log_uniform(1e-8, 1e-2);
        wo.push_back(o);
        wi.push_back(std::cos(apart) * mirror +
                     std::sin(apart) * glm::normalize(any - glm::dot(any, mirror) * mirror));
        x.push_back(2 * std::sin(apart / 2) * std::sin(apart / 2));
    }
    const ModelProbe<float> probe("rational");
    for (const double n : {0.0, 1.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e10, 1e12}) {
        const auto out = probe.eval({{{"kd", 0}, {"ks", 1}, {"n", n}}}, wo, wi);
        double worst = 0;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const Long exact = (1 - x[i]) / (1 - x[i] + static_cast<float>(n) * x[i]) * wi[i].z;
            worst = std::max(worst, relative_error(out[i].f.x, exact));
        }
        EXPECT_LE(worst, 4 * std::sqrt(n / 2) * 0x1p-24 + 4 * 0x1p-23) << n;
    }
}

// u.x = 0 is the mirror direction itself, with the lobe's density at its peak.
TEST(BrdfNumbersItems, FirstNumberIsThePeak) {
    const vec3l wo(glm::vec3(direction(radians(30))));
    for (const char* model : models) {
        const ModelProbe<float> probe(model);
        for (const double n : ns) {
            const auto s = probe.sample({{{"kd", 0}, {"ks", 1}, {"n", n}}}, {wo, wo},
                                        {vec3l(0, .3, .5), vec3l(1 - 0x1p-24L, .5, .5)});
            EXPECT_EQ(s[0].wi.x, static_cast<double>(-wo.x)) << model << " " << n;
            EXPECT_EQ(s[0].wi.y, static_cast<double>(-wo.y)) << model << " " << n;
            EXPECT_EQ(s[0].wi.z, static_cast<double>(wo.z)) << model << " " << n;
            EXPECT_NEAR(s[0].pdf * area_of(model, static_cast<float>(n)), 1, 1e-5)
                << model << " " << n;
            EXPECT_TRUE(std::isfinite(s[1].pdf) && std::isfinite(s[1].weight.x)) << model << n;
        }
    }
}

// Without diffuse part a sample weighs what the visible part of its circle leaves of the lobe's
// area: times the cosine, or without it for Phong's model.
TEST(BrdfNumbersItems, WeightsOfLobesAlone) {
    Random random(83);
    std::vector<vec3l> wo, u;
    for (int i = 0; i < 4096; ++i) {
        wo.push_back(vec3l(glm::vec3(
            direction(std::acos(Long(random.uniform(.05, 1))), random.uniform(0, 6.28)))));
        u.push_back({random.uniform_float(), random.uniform_float(), random.uniform_float()});
    }
    for (const char* model : models) {
        const ModelProbe<float> probe(model);
        for (const double n : {.1, 1.0, 10.0, 1e3, 1e6}) {
            const auto samples = probe.sample({{{"kd", 0}, {"ks", 1}, {"n", n}}}, wo, u);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                const BrdfSampled& s = samples[i];
                if (s.pdf == 0 || s.wi.z < 1e-3) continue;
                const vec3l mirror(-wo[i].x, -wo[i].y, wo[i].z), d = mirror - vec3l(s.wi);
                const Long x = glm::dot(d, d) / 2, t = 1 - x, sine = std::sqrt(x * (2 - x));
                const Long side = std::hypot(wo[i].x, wo[i].y);
                const Long arc =
                    t * wo[i].z >= sine * side ? 1 : std::acos(-t * wo[i].z / (sine * side)) / pi;
                const double cosine = model == std::string("phong") ? 1 : s.wi.z;
                const double expected =
                    area_of(model, static_cast<float>(n)) * double(arc) * cosine;
                ASSERT_NEAR(s.weight.x / expected, 1, 2e-3) << model << " n " << n << " u " << i;
                ASSERT_LE(s.weight.x, area_of(model, static_cast<float>(n)) * (1 + 1e-5));
            }
        }
    }
}

// f cos of Phong's model is kd cos + ks c^n however little of the cosine there is; f alone, as its
// formula has it, overflows. The other models go dark.
TEST(BrdfNumbersItems, GrazingLight) {
    const vec3l wo = direction(radians(89.5));
    const BrdfValues values = {{"kd", .25}, {"ks", .5}, {"n", 10}};
    for (const char* model : models) {
        const ModelProbe<float> probe(model);
        for (const Long z : {0.0L, 1e-38L, 1e-20L, 1e-7L}) {
            const vec3l wi(-wo.x / std::hypot(wo.x, wo.y), -wo.y / std::hypot(wo.x, wo.y), z);
            const double f = probe.eval({values}, {wo}, {wi})[0].f.x;
            const Long c = -wo.x * wi.x - wo.y * wi.y + wo.z * z;
            if (model == std::string("phong"))
                EXPECT_NEAR(f / double(.25L * z + .5L * std::pow(c, 10)), 1, 1e-6) << double(z);
            else
                EXPECT_LE(f, 0.75 * double(z) + 1e-45) << model << " " << double(z);
        }
    }
}

// Phong's f times the cosine, as printed: no number at 0, and infinite wherever f overflows, a
// fifth of cosines from 1e-37 to 1e-20 at n = 1e6 (published for other parts of the lobe: 17.6
// percent).
TEST(BrdfNumbersItems, PhongTimesTheCosine) {
    const KernelText kernels;
    BrdfProbe probe(test_device(), kernels,
                    parse_brdf_table("brdf/phong.h", kernels.read("brdf/phong.h")));
    const double n = 1e6, ks = (n + 1) / (2 * static_cast<double>(pi));
    probe.set_parameters({brdf_rows(probe.model(), {{"kd", .25}, {"ks", ks}, {"n", n}})});
    Random random(84);
    constexpr int count = 20000;
    BrdfQuery query;
    int overflows = 0;
    for (int i = 0; i < count; ++i) {
        const double z = random.log_uniform(1e-37, 1e-20), turn = random.log_uniform(1e-5, 2e-3);
        query.add(0, {1, 0, random.log_uniform(1e-37, 1e-20)},
                  {-std::cos(turn), std::sin(turn), z});
        overflows += ks * std::exp(-n * turn * turn / 2) / z > 3.4028235e38;
    }
    query.add(0, {1, 0, 1e-3}, {-1, 0, 0});
    const auto printed = probe.formula(query);
    const auto ours = probe.eval(query);
    int infinite = 0;
    for (int i = 0; i < count; ++i) {
        ASSERT_TRUE(std::isfinite(ours[i].f.x) && ours[i].f.x >= 0);
        infinite += !std::isfinite(printed[i].x);
    }
    std::printf("  overflows: %.1f %% (published 17.6 %%)\n", 100.0 * infinite / count);
    EXPECT_NEAR(infinite, overflows, 0.002 * count);
    EXPECT_NEAR(100.0 * infinite / count, 20.6, 1);
    EXPECT_FALSE(std::isfinite(printed[count].x * 0.0));
    EXPECT_NEAR(ours[count].f.x, ks * std::exp(-n * .5e-6), ks * 2e-5);
}

// The density at the peak of cos^n for n = 1e30 is 1.6e29, whose square no float holds.
TEST(BrdfNumbersItems, DensitiesWhoseSquareOverflows) {
    const ModelProbe<float> probe("phong");
    const vec3l wo(glm::vec3(direction(radians(30)))), mirror(-wo.x, -wo.y, wo.z);
    const double pdf = probe.eval({{{"kd", 0}, {"n", 1e30}}}, {wo}, {mirror})[0].pdf;
    EXPECT_TRUE(has_digits(pdf, "1.59e29"));
    EXPECT_TRUE(std::isinf(static_cast<float>(pdf) * static_cast<float>(pdf)));
    const Program program = build_probe("probe/math.cl");
    Buffer<float> out(test_device(), 2);
    run_probe(program, "math_power_heuristic", 2,
              Buffer<float>(test_device(), std::vector<float>{float(pdf), float(pdf)}),
              Buffer<float>(test_device(), std::vector<float>{float(pdf), 1}), out);
    EXPECT_EQ(out.read_all(), (std::vector<float>{0.5f, 1}));
}

// No program is built with options that relax arithmetic, nor do kernels call what is allowed to be
// inexact.
TEST(BrdfNumbersItems, RelaxedArithmeticIsForbidden) {
    const Program program = build_probe("probe/brdf_lobe.cl");
    const auto options =
        program.program.getBuildInfo<CL_PROGRAM_BUILD_OPTIONS>(test_device().device());
    for (const char* word : {"relaxed", "unsafe", "finite-math", "mad-enable", "denorms"})
        EXPECT_EQ(options.find(word), std::string::npos) << options;
    const KernelText kernels;
    const std::regex inexact(
        "\\b(native_[a-z0-9]+|half_(cos|divide|exp|exp2|exp10|log|log2|log10|powr|recip|rsqrt|sin|"
        "sqrt|"
        "tan)|fast_(distance|length|normalize)) *\\(");
    for (const std::string& path : kernels.list(""))
        EXPECT_FALSE(std::regex_search(kernels.read(path), inexact)) << path;
}

// With it, the normalisation of the sharpest lobes overflows: products are taken in another order.
TEST(BrdfNumbersItems, RelaxedArithmeticFails) {
    if (test_device().info().platform.find("Portable Computing Language") == std::string::npos)
        GTEST_SKIP() << "what relaxed arithmetic does is known of PoCL only";
    Program relaxed;
    relaxed.program =
        cl::Program(test_device().context(), flatten(KernelText(), "probe/brdf_lobe.cl", {}));
    relaxed.program.build({test_device().device()}, "-cl-std=CL1.2 -cl-fast-relaxed-math");
    const Buffer<float> n(test_device(), std::vector<float>{3e38f});
    Buffer<float> out(test_device(), 2);
    run_probe(relaxed, "lobe_moments", 1, n, out);
    EXPECT_FALSE(std::isfinite(out.read_all()[0]));
    run_probe(build_probe("probe/brdf_lobe.cl"), "lobe_moments", 1, n, out);
    EXPECT_NEAR(out.read_all()[0] / 2.9199e-37, 1, 1e-4);
}
