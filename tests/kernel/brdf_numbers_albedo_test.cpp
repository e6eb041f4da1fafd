// SPDX-License-Identifier: Apache-2.0
// Known albedos, to the digits given: largest albedos and what they leave for ks, angular profiles,
// the two sides of Phong's model. From the closed forms and one-dimensional integrals of the lobes,
// in 40 digits.
#include <gtest/gtest.h>

#include "base/kernel_text.h"
#include "kernel/brdf_numbers.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const double two_pi = 2 * static_cast<double>(pi);

// n, then for the rational model, the modified one and Phong's seen from the viewer: the albedo of
// ks = 1 at normal incidence, and the largest ks.
const char* const largest[] = {"0 3.14159 .318310 3.14159 .318310 6.28319 .159155",
                               ".1 2.91341 .343240 2.99199 .334225 5.71199 .175070",
                               "1 2.09440 .477465 2.09440 .477465 3.14159 .318310",
                               "10 .859810 1.16305 .523599 1.90986 .571199 1.75070",
                               "100 .202368 4.94150 .0615999 16.2338 .0622098 16.0746",
                               "1e3 .0340927 29.3318 .00627064 159.473 .00627691 159.314",
                               "1e4 .00484613 206.350 6.28193e-4 1591.87 6.28256e-4 1591.71",
                               "1e6 7.73809e-5 12923.1 6.28317e-6 159155 6.28318e-6 159155"};

BrdfValues lobe_alone(double n, double ks = 1) { return {{"kd", 0}, {"ks", ks}, {"n", n}}; }

bool claims_energy(const std::string& model, const BrdfValues& values) {
    const KernelText kernels;
    const std::string file = "brdf/" + model + ".h";
    BrdfProbe probe(test_device(), kernels, parse_brdf_table(file, kernels.read(file)));
    probe.set_parameters({brdf_rows(probe.model(), values)});
    return probe.claims()[0].conserves_energy;
}

}  // namespace

TEST(BrdfNumbersAlbedo, LargestAlbedoAndLargestKs) {
    const char* names[] = {"rational", "modified_phong", "phong"};
    for (int model = 0; model < 3; ++model) {
        const ModelProbe<float> probe(names[model]);
        for (const char* line : largest) {
            const auto row = words(line);
            const double n = std::atof(row[0].c_str());
            const double albedo = integrals_at(probe, lobe_alone(n), 0, n).albedo;
            EXPECT_TRUE(has_digits(albedo, row[1 + 2 * model])) << names[model] << " n " << n;
            EXPECT_TRUE(has_digits(1 / albedo, row[2 + 2 * model])) << names[model] << " n " << n;
        }
    }
}

// The table's ks is the last that is claimed to conserve energy; none is for Phong's model.
TEST(BrdfNumbersAlbedo, EnergyIsClaimedUpToTheLargestKs) {
    const char* names[] = {"rational", "modified_phong"};
    for (const char* line : {largest[3], largest[6]}) {
        const auto row = words(line);
        const double n = std::atof(row[0].c_str());
        for (int model = 0; model < 2; ++model) {
            const double ks = std::atof(row[2 + 2 * model].c_str());
            EXPECT_TRUE(claims_energy(names[model], lobe_alone(n, ks * (1 - 1e-5)))) << line;
            EXPECT_FALSE(claims_energy(names[model], lobe_alone(n, ks * (1 + 1e-5)))) << line;
            // With a diffuse part: ks <= (1 - pi kd) times that.
            const double kd = 0.1, left = 1 - static_cast<double>(pi) * kd;
            EXPECT_TRUE(claims_energy(names[model],
                                      {{"kd", kd}, {"ks", ks * left * (1 - 1e-5)}, {"n", n}}));
            EXPECT_FALSE(claims_energy(names[model],
                                       {{"kd", kd}, {"ks", ks * left * (1 + 1e-5)}, {"n", n}}));
        }
        EXPECT_FALSE(claims_energy("phong", lobe_alone(n, 1e-6)));
    }
}

// Unit ks at 0, 30, 45, 60, 75, 85 and 90 degrees.
TEST(BrdfNumbersAlbedo, AngularProfiles) {
    struct {
        const char* model;
        double n;
        const char* at;
    } const rows[] = {{"rational", 1, "2.0944 1.8448 1.5821 1.2755 .9602 .7605 .6667"},
                      {"rational", 10, ".8598 .7486 .6230 .4706 .3142 .2215 .18157"},
                      {"rational", 100, ".20237 .17566 .14469 .10572 .06366 .03826 .02819"},
                      {"rational", 1e3, ".034093 .029566 .024268 .017505 .009985 .005191 .003305"},
                      {"modified_phong", 10, ".5236 .45345 .37038 .26428 .15284 .08968 .06443"},
                      {"modified_phong", 100, ".0616 .05335 .04356 .0308 .01595 .006013 .002451"}};
    const double degrees[] = {0, 30, 45, 60, 75, 85};
    for (const auto& row : rows) {
        const ModelProbe<float> probe(row.model);
        const auto at = words(row.at);
        for (int i = 0; i < 6; ++i)
            EXPECT_TRUE(
                has_digits(integrals_at(probe, lobe_alone(row.n), degrees[i], row.n).albedo, at[i]))
                << row.model << " n " << row.n << " at " << degrees[i];
        const auto horizon =
            integrals_of(probe, lobe_alone(row.n), vec3l(1, 0, 1e-30L), 1 / Long(row.n));
        EXPECT_TRUE(has_digits(horizon.albedo, at[6], 1e-5)) << row.model << " n " << row.n;
    }
}

// At 90 degrees: closed forms, and Beta((n + 1) / 2, 3 / 2) for the modified model.
TEST(BrdfNumbersAlbedo, AtTheHorizon) {
    const ModelProbe<float> rational("rational"), modified("modified_phong");
    const vec3l wo(1, 0, 1e-30L);
    const char* const at[] = {"10 .181572936601", "100 .0281937424538", "1e3 .00330491819267"};
    for (const char* line : at) {
        const auto row = words(line);
        const double n = std::atof(row[0].c_str());
        EXPECT_TRUE(
            has_digits(integrals_of(rational, lobe_alone(n), wo, 1 / Long(n)).albedo, row[1], 1e-5))
            << n;
    }
    for (double n : {0.0, 1.0, 10.0, 100.0, 1e3, 1e4}) {
        const double beta =
            std::exp(std::lgamma((n + 1) / 2) + std::lgamma(1.5) - std::lgamma((n + 4) / 2));
        const auto found = integrals_of(modified, lobe_alone(n), wo, 1 / Long(std::max(n, 1.0)));
        EXPECT_NEAR(found.albedo / beta, 1, 2e-5) << n;
    }
}

// A grazing beam is multiplied by Phong's model, the more the closer to the horizon: mu_i times the
// albedo tends to Beta((n + 1) / 2, 3 / 2).
TEST(BrdfNumbersAlbedo, PhongSeenFromTheLight) {
    const ModelProbe<float> phong("phong");
    const char* const rows[] = {"10 .5236 .5236 .5286 .5905 1.029 3.959 37.18",
                                "100 .0616 .0616 .0616 .0616 .0690 .1734 1.4355"};
    const double degrees[] = {0, 30, 60, 75, 85, 89, 89.9};
    for (const char* line : rows) {
        const auto row = words(line);
        const double n = std::atof(row[0].c_str());
        for (int i = 0; i < 7; ++i)
            EXPECT_TRUE(has_digits(light_side_albedo(phong, lobe_alone(n), degrees[i], n),
                                   row[i + 1], 2e-5))
                << "n " << n << " at " << degrees[i];
    }
    const Long near = radians(89.9999);
    EXPECT_NEAR(
        light_side_albedo(phong, lobe_alone(10), 89.9999, 10) * static_cast<double>(std::cos(near)),
        .0644271930912, 1e-6);
    EXPECT_NEAR(light_side_albedo(phong, lobe_alone(100), 89.9999, 100) *
                    static_cast<double>(std::cos(near)),
                .00245134277922, 1e-7);
    // With ks = (n + 1) / (2 pi), all that the viewer's side permits.
    EXPECT_TRUE(has_digits(light_side_albedo(phong, lobe_alone(10, 11 / two_pi), 85, 10), "1.80"));
    EXPECT_TRUE(has_digits(light_side_albedo(phong, lobe_alone(10, 11 / two_pi), 89, 10), "6.93"));
}

// How much brighter the rational lobe is at equal n and ks: J(n) (n + 1).
TEST(BrdfNumbersAlbedo, RationalOutshinesThePowerAtEqualN) {
    const ModelProbe<float> rational("rational"), power("modified_phong");
    for (const char* line : {"10 1.90", "100 3.73", "1e3 5.93", "1e4 8.21", "1e6 12.8"}) {
        const auto row = words(line);
        const double n = std::atof(row[0].c_str());
        EXPECT_TRUE(has_digits(integrals_at(rational, lobe_alone(n), 0, n).lobe /
                                   integrals_at(power, lobe_alone(n), 0, n).lobe,
                               row[1], 2e-5))
            << n;
    }
}

// Lobes over the larger of the two cosines, of area 1: at n = 20 and 0, 30, 60, 75, 85, 89 degrees.
TEST(BrdfNumbersAlbedo, StretchedLobes) {
    const ModelProbe<float> rational("stretched_rational"), power("neumann_neumann");
    const double j = (20 * std::log(20.0) - 19) / (19 * 19);
    const auto check = [](const ModelProbe<float>& probe, double area, const char* at) {
        const double degrees[] = {0, 30, 60, 75, 85, 89};
        for (int i = 0; i < 6; ++i)
            EXPECT_TRUE(
                has_digits(integrals_at(probe, lobe_alone(20, 1 / area), degrees[i], 20).albedo,
                           words(at)[i], 1e-5))
                << probe.name() << " at " << degrees[i];
    };
    check(rational, two_pi * j, ".820 .799 .699 .614 .540 .508");
    check(power, two_pi / 21, ".955 .926 .832 .709 .576 .515");
}
