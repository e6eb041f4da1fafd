// SPDX-License-Identifier: Apache-2.0
// Directional albedos by quadrature of the device's own values, against closed forms: what leaves
// towards the viewer under light 1 from everywhere (the camera's side of a furnace).
#include <gtest/gtest.h>

#include "kernel/brdf_grid.h"
#include "kernel/brdf_probe.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const double kd = 0.25 / static_cast<double>(pi);

double albedo(const ModelProbe<float>& probe, const BrdfValues& values, const vec3l& wo,
              Long width) {
    const HemisphereGrid grid(wo, rings_of_width(width));
    const auto out = probe.eval({values}, std::vector<vec3l>(grid.nodes.size(), wo), grid.nodes);
    Long sum = 0;
    for (std::size_t i = 0; i < out.size(); ++i) sum += grid.weights[i] * out[i].f.x;
    return static_cast<double>(sum);
}

double albedo_at(const ModelProbe<float>& probe, const BrdfValues& values, double degrees,
                 double n) {
    return albedo(probe, values, direction(radians(degrees)), 1 / std::max(n, 1.0));
}

// Albedo of what light from wi reflects to all sides: the adjoint, f cos theta_o.
double adjoint_albedo(const ModelProbe<float>& probe, const BrdfValues& values, double degrees,
                      double n) {
    const vec3l wi = direction(radians(degrees));
    const HemisphereGrid grid(wi, rings_of_width(1 / std::max(n, 1.0)));
    const auto out = probe.eval({values}, grid.nodes, std::vector<vec3l>(grid.nodes.size(), wi));
    Long sum = 0;
    for (std::size_t i = 0; i < out.size(); ++i)
        sum += grid.weights[i] * out[i].f.x * grid.nodes[i].z / wi.z;
    return static_cast<double>(sum);
}

struct FurnaceRow {
    double n;
    double at[4][3];  // angle 0, 45, 80, 89; rational, modified, Phong
};

// kd = .25 / pi and a specular albedo of .5 at normal incidence; from 1-D integrals in 20 digits.
const FurnaceRow furnace[] = {
    {1,
     {{.75, .75, .75},
      {.627705, .627705, .676777},
      {.454973, .454973, .543412},
      {.413542, .413542, .504363}}},
    {10,
     {{.75, .75, .75},
      {.612310, .603687, .748282},
      {.404693, .364028, .607381},
      {.360011, .315980, .511282}}},
    {100,
     {{.75, .75, .75},
      {.607499, .603553, .75},
      {.374399, .337616, .730150},
      {.324151, .274563, .534725}}},
    {1e3,
     {{.75, .75, .75},
      {.605910, .603553, .75},
      {.360103, .336824, .75},
      {.303117, .261606, .604776}}},
    {1e5,
     {{.75, .75, .75}, {.604831, .603553, .75}, {.349504, .336824, .75}, {.283633, .258726, .75}}},
};

}  // namespace

TEST(BrdfAlbedo, FurnaceTable) {
    const char* models[] = {"rational", "modified_phong", "phong"};
    const double degrees[] = {0, 45, 80, 89};
    for (int model = 0; model < 3; ++model) {
        const ModelProbe<float> probe(models[model]);
        for (const FurnaceRow& row : furnace) {
            // The models take albedos: kd = .25 and ks = .5.
            const BrdfValues values = {{"kd", .25}, {"ks", .5}, {"n", row.n}, {"normalize", 1}};
            for (int i = 0; i < 4; ++i)
                EXPECT_NEAR(albedo_at(probe, values, degrees[i], row.n), row.at[i][model], 2e-5)
                    << models[model] << " n " << row.n << " at " << degrees[i];
        }
    }
}

TEST(BrdfAlbedo, UnnormalisedAtNormalIncidence) {
    const double two_pi = 2 * static_cast<double>(pi);
    struct Row {
        double n, rational_k;
    } rows[] = {{0, .5},
                {1, 1.0 / 3},
                {2, .272588722240},
                {10, .136842948285},
                {100, .032207805903},
                {1e4, 7.7128539918e-4},
                {1e6, 1.23155495046e-5}};
    const ModelProbe<float> rational("rational"), modified("modified_phong"), phong("phong");
    for (const Row& row : rows) {
        const BrdfValues values = {{"kd", 0}, {"ks", 1}, {"n", row.n}};
        EXPECT_NEAR(albedo_at(rational, values, 0, row.n) / (two_pi * row.rational_k), 1, 3e-5)
            << row.n;
        EXPECT_NEAR(albedo_at(modified, values, 0, row.n) / (two_pi / (row.n + 2)), 1, 3e-5)
            << row.n;
        EXPECT_NEAR(albedo_at(phong, values, 0, row.n) / (two_pi / (row.n + 1)), 1, 3e-5) << row.n;
    }
}

// At 90 degrees, and for n = 0 at all angles, there are closed forms for the rational lobe.
TEST(BrdfAlbedo, RationalClosedForms) {
    const ModelProbe<float> probe("rational");
    const double at_horizon[][2] = {
        {1, 2.0 / 3}, {10, .181572936601}, {100, .0281937424538}, {1e3, .00330491819267}};
    for (const auto& row : at_horizon)
        EXPECT_NEAR(
            albedo(probe, {{"kd", 0}, {"ks", 1}, {"n", row[0]}}, vec3l(1, 0, 1e-30L), 1 / row[0]) /
                row[1],
            1, 1e-4)
            << row[0];
    for (double degrees : {0.0, 30.0, 60.0, 85.0})
        EXPECT_NEAR(albedo_at(probe, {{"kd", 0}, {"ks", 1}, {"n", 0}}, degrees, 1),
                    static_cast<double>(pi / 2 * (1 + std::cos(radians(degrees)))), 1e-5);
    // The angular profile for n = 1 and 100, and |cos|: Lambert at n = 0, twice as bright at 89.
    EXPECT_NEAR(albedo_at(probe, {{"kd", 0}, {"ks", 1}, {"n", 1}}, 60, 1), 1.2755, 1e-4);
    EXPECT_NEAR(albedo_at(probe, {{"kd", 0}, {"ks", 1}, {"n", 100}}, 75, 100), .06366, 1e-5);
    EXPECT_NEAR(albedo_at(probe, {{"kd", 0}, {"ks", 1}, {"n", 0}, {"lobe", 1}}, 50, 1),
                static_cast<double>(pi), 1e-5);
    EXPECT_NEAR(
        albedo_at(probe, {{"kd", 0}, {"ks", 1}, {"n", 20}, {"normalize", 1}, {"lobe", 1}}, 89, 20),
        .372, 1e-3);
    EXPECT_NEAR(albedo_at(probe, {{"kd", 0}, {"ks", 1}, {"n", 20}, {"normalize", 1}}, 89, 20), .195,
                1e-3);
}

// The reading of the 2019 listing depends on the viewer only: kd exactly at 45 degrees.
TEST(BrdfAlbedo, Listing) {
    const ModelProbe<float> probe("rational");
    const double inv_pi = static_cast<double>(1 / pi);
    const double at[][2] = {{0, 1}, {30, .048}, {60, .048}, {75, .244}, {85, .764}, {89, .988}};
    for (const auto& row : at)
        EXPECT_NEAR(
            albedo_at(probe, {{"kd", 0}, {"ks", inv_pi}, {"n", 20}, {"lobe", 2}}, row[0], 1),
            row[1], 6e-4);
    EXPECT_NEAR(albedo_at(probe, {{"kd", kd}, {"ks", inv_pi}, {"n", 20}, {"lobe", 2}}, 45, 1), .25,
                1e-6);
}

// No model that claims to conserve energy may reflect more than it says; brightest at the normal.
TEST(BrdfAlbedo, ConservedWhereClaimed) {
    for (const char* model : {"rational", "modified_phong"}) {
        const ModelProbe<float> probe(model);
        for (double n : {0.0, .1, 1.0, 10.0, 100.0, 1e4, 1e6}) {
            double last = 1 + 1e-4;
            for (double degrees : {0.0, 30.0, 45.0, 60.0, 75.0, 85.0, 90.0}) {
                const double value =
                    albedo_at(probe, {{"kd", .2}, {"ks", .8}, {"n", n}, {"normalize", 1}},
                              std::min(degrees, 89.99), n);
                EXPECT_LE(value, last) << model << " n " << n << " at " << degrees;
                last = value * (1 + 1e-5);
            }
        }
    }
}

// Phong cannot conserve energy: seen from the light, a grazing beam is multiplied.
TEST(BrdfAlbedo, PhongMultipliesGrazingLight) {
    const ModelProbe<float> phong("phong");
    const BrdfValues values = {{"kd", 0}, {"ks", 1}, {"n", 10}};
    const double at[][2] = {{0, .5236},  {30, .5236}, {60, .5286},  {75, .5905},
                            {85, 1.029}, {89, 3.959}, {89.9, 37.18}};
    for (const auto& row : at)
        EXPECT_NEAR(adjoint_albedo(phong, values, row[0], 10) / row[1], 1, 1e-3) << row[0];
    // The camera's side looks sound all the while.
    EXPECT_LT(albedo_at(phong, {{"kd", 0}, {"ks", 1}, {"n", 10}, {"normalize", 1}}, 89, 10), 1);
    // The modified model reflects alike from both sides.
    const ModelProbe<float> modified("modified_phong");
    EXPECT_NEAR(adjoint_albedo(modified, values, 89, 10) / albedo_at(modified, values, 89, 10), 1,
                1e-5);
}

// Facets that reflect all lose what would bounce between them, and never gain.
TEST(BrdfAlbedo, MicrofacetsGainNothing) {
    const ModelProbe<float> conductor("conductor");
    const auto white = [&](double alpha_x, double alpha_y, double degrees) {
        return albedo_at(conductor,
                         {{"eta", 0}, {"k", 100}, {"alpha_x", alpha_x}, {"alpha_y", alpha_y}},
                         degrees, 10 / alpha_x / alpha_y);
    };
    // alpha = 1 at normal incidence: half of all directions uniformly, weight 2 z / (1 + z).
    EXPECT_NEAR(white(1, 1, 0), 1 - std::log(2.0), 1e-5);
    for (double alpha : {.01, .1, .3, 1.0})
        for (double degrees : {0.0, 45.0, 80.0}) EXPECT_LE(white(alpha, alpha, degrees), 1 + 1e-4);
    EXPECT_GT(white(.01, .01, 45), .999);
    EXPECT_LT(white(.1, .4, 45), white(.1, .1, 45));
}
