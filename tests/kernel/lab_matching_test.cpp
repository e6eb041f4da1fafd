// SPDX-License-Identifier: Apache-2.0
// The rational lobe matched to cos^m by measurement on the device, against the roots of the closed
// forms and against the table of values worked out from them with 20 digits.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "base/kernel_text.h"
#include "lab/measure/matching.h"
#include "support/device.h"

using namespace lobe;
using namespace lobe::test;

namespace {

BrdfProbe make_probe(const std::string& model, Precision precision = Precision::single) {
    const KernelText kernels;
    const std::string file = "brdf/" + model + ".h";
    return BrdfProbe(test_device(), kernels, parse_brdf_table(file, kernels.read(file)), precision);
}

Sharpened lobe_alone(BrdfProbe& probe) {
    return find_sharpness(probe, set_up(probe.model(), {{"", "kd", "0"}, {"", "ks", "1"}}));
}

// One row: n of the rational lobe for cos^m. Texts, for their last digit says how far they go.
struct Printed {
    double m;
    const char *half_width, *integral, *albedo, *median;
};
const std::vector<Printed> printed = {{1, "1", "1", "1", "1"},
                                      {2, "2.414", "2.817", "2.567", "3.54"},
                                      {5, "6.725", "10.68", "9.20", "20.3"},
                                      {10, "13.93", "28.02", "24.01", "79.0"},
                                      {100, "143.8", "535.9", "480.2", "7681"},
                                      {1e3, "1442", "7997", "7432", "7.66e5"},
                                      {1e4, "14426", "1.057e5", "1.002e5", "7.66e7"},
                                      {1e6, "1.4427e6", "1.556e7", "1.503e7", "7.66e11"}};

// Half of the last digit; a text without a point has no fewer than three of them.
double half_digit(const std::string& text) {
    const auto e = std::min(text.find('e'), text.size()), dot = std::min(text.find('.'), e);
    const double power = e < text.size() ? std::atof(text.c_str() + e + 1) : 0;
    const double digits = dot < e ? static_cast<double>(e - dot - 1) : text.size() < 3 ? 3 : 0;
    return 0.5 * std::pow(10.0, power - digits);
}

double rational_integral(double n) {  // over the cosine, from 0 to 1
    const double a = n - 1;
    return std::abs(a) < 1e-4 ? 0.5 - a / 6 : (n * std::log(n) - a) / (a * a);
}
double rational_albedo(double n) {
    const double a = n - 1;
    return std::abs(a) < 1e-3 ? 1.0 / 3 - a / 12 + a * a / 30
                              : (n * rational_integral(n) - 0.5) / a;
}
double rational_within(double n, double x) {  // 1 - cos at most x, as a part of the whole
    const double a = n - 1;
    if (std::abs(a) < 1e-4) return 2 * x - x * x;
    return (n * std::log1p(a * x) - a * x) / (a * a) / rational_integral(n);
}

template <typename Function>
double root(const Function& f) {
    double low = std::log(1e-3), high = std::log(1e15);
    const bool falls = f(1e-3) > 0;
    for (int k = 0; k < 200; ++k) {
        const double middle = 0.5 * (low + high);
        ((f(std::exp(middle)) > 0) == falls ? low : high) = middle;
    }
    return std::exp(low);
}

std::array<double, 5> closed_form(double m) {
    const double x = -std::expm1(-std::log(2.0) / (m + 1));
    return {m, 1 / std::expm1(std::log(2.0) / m),
            root([&](double n) { return rational_integral(n) - 1 / (m + 1); }),
            root([&](double n) { return rational_albedo(n) - 1 / (m + 2); }),
            root([&](double n) { return rational_within(n, x) - 0.5; })};
}

std::vector<double> exponents() {
    std::vector<double> values;
    for (const Printed& row : printed) values.push_back(row.m);
    return values;
}

void expect_the_table(const Sharpened& own, const Sharpened& other) {
    const std::vector<Match> matches = match_lobes(own, other, exponents());
    ASSERT_EQ(matches.size(), printed.size());
    for (std::size_t i = 0; i < matches.size(); ++i) {
        const Printed& row = printed[i];
        SCOPED_TRACE("m = " + std::to_string(row.m));
        EXPECT_NEAR(matches[i].matched[0], row.m, 2e-4 * row.m);
        const char* const texts[] = {row.half_width, row.integral, row.albedo, row.median};
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_NEAR(matches[i].matched[k + 1], std::atof(texts[k]), half_digit(texts[k]))
                << criteria[k + 1].name;
    }
}

}  // namespace

TEST(LabMatching, RationalToCosinePowersIsTheKnownTable) {
    BrdfProbe rational = make_probe("rational"), power = make_probe("modified_phong");
    expect_the_table(lobe_alone(rational), lobe_alone(power));
}

// A diffuse part as large as the lobe takes digits from the tail of sharp ones: in double there are
// enough, and the table is the same.
TEST(LabMatching, ADiffusePartDoesNotMatterInDouble) {
    LOBE_NEEDS_DOUBLE();
    BrdfProbe rational = make_probe("rational", Precision::twice);
    BrdfProbe power = make_probe("modified_phong", Precision::twice);
    expect_the_table(find_sharpness(rational, set_up(rational.model(), {})),
                     find_sharpness(power, set_up(power.model(), {})));
}

TEST(LabMatching, WhatIsOutOfReachIsNotMatched) {
    BrdfProbe own_probe = make_probe("blinn_phong"), other_probe = make_probe("modified_phong");
    // No half vector's lobe is so wide.
    const Match match = match_lobes(lobe_alone(own_probe), lobe_alone(other_probe), {0.3})[0];
    EXPECT_TRUE(std::isnan(match.matched[1]));
}

TEST(LabMatching, AModelWithoutASharpnessIsRefusedByName) {
    BrdfProbe lambert = make_probe("lambert"), rational = make_probe("rational");
    try {
        find_sharpness(lambert, set_up(lambert.model(), {}));
        ADD_FAILURE() << "lambert has no lobe";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_NE(std::string(error.what()).find("'lambert' has no parameter"), std::string::npos);
    }
    using Places = std::vector<std::size_t>;
    EXPECT_EQ(shaping_parameters(rational, set_up(rational.model(), {}), "kd"), Places());
    EXPECT_EQ(shaping_parameters(rational, set_up(rational.model(), {}), "n"), Places({2}));
    // Both roughnesses of an anisotropic model together, unless one is named.
    BrdfProbe conductor = make_probe("conductor");
    const Subject metal = set_up(conductor.model(), {});
    EXPECT_EQ(find_sharpness(conductor, metal).name(), "alpha_x=alpha_y");
    EXPECT_EQ(find_sharpness(conductor, metal, "alpha_x").name(), "alpha_x");
}

TEST(LabMatching, AgreesWithTheClosedForms) {
    BrdfProbe rational = make_probe("rational"), power = make_probe("modified_phong");
    const Sharpened own = lobe_alone(rational), other = lobe_alone(power);
    for (const Match& match : match_lobes(own, other, {1.5, 7, 33, 420, 25000, 3e5})) {
        const std::array<double, 5> expected = closed_form(match.value);
        for (std::size_t k = 0; k < expected.size(); ++k)
            EXPECT_NEAR(match.matched[k] / expected[k], 1, 1e-4)
                << criteria[k].name << " at m = " << match.value;
    }
}
