// SPDX-License-Identifier: Apache-2.0
// What the laboratory measures of lobes, against closed forms, and one way of integrating against
// the other.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/kernel_text.h"
#include "base/luminance.h"
#include "lab/measure/albedo.h"
#include "lab/measure/lobe_shape.h"
#include "lab/measure/plane.h"
#include "lab/settings.h"
#include "support/device.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double pi = 3.14159265358979;

const KernelText& kernels() {
    static const KernelText text;
    return text;
}

BrdfProbe make_probe(const std::string& model) {
    const std::string file = "brdf/" + model + ".h";
    return BrdfProbe(test_device(), kernels(), parse_brdf_table(file, kernels().read(file)));
}

double half_width_of(const std::string& model, double n) {
    return model == "rational" ? 2 * std::asin(std::sqrt(0.5 / (n + 1)))
                               : 2 * std::asin(std::sqrt(-0.5 * std::expm1(-std::log(2.0) / n)));
}

}  // namespace

TEST(LabPlane, HalfWidthsAreThoseOfTheFormulasFromAnyAngle) {
    for (const char* const model : {"rational", "modified_phong"}) {
        BrdfProbe probe = make_probe(model);
        const std::vector<double> ns = {2, 10, 100, 1e4, 1e6, 1e8};
        std::vector<BrdfRows> sets;
        for (const double n : ns) sets.push_back(brdf_rows(probe.model(), {{"n", n}}));
        probe.set_parameters(sets);
        std::vector<PlaneView> views;
        for (std::uint32_t set = 0; set < ns.size(); ++set)
            for (const double degrees : {0, 20, 45, 70})
                views.push_back({set, glm::radians(degrees)});
        const std::vector<PlaneLobe> lobes = Plane(probe, 0.3).lobes(views);
        for (std::size_t i = 0; i < views.size(); ++i) {
            SCOPED_TRACE(std::string(model) + " n = " + std::to_string(ns[views[i].set]) + " at " +
                         std::to_string(glm::degrees(views[i].view)));
            const double wanted = half_width_of(model, ns[views[i].set]);
            ASSERT_TRUE(lobes[i].any);
            // Float directions are some 6e-8 off, but next to the normal; a wide lobe that is cut
            // by the horizon on one side keeps its other side.
            const double close = 2e-4 + (views[i].view > 0 ? 2e-7 / wanted : 0);
            EXPECT_NEAR(lobes[i].at, views[i].view, 1e-3 * wanted + 1e-7);
            EXPECT_NEAR(lobes[i].peak, 0.5, 1e-5);
            if (views[i].view + wanted < 1.5) {
                EXPECT_NEAR(lobes[i].above.value_or(0) / wanted, 1, close);
            }
            if (lobes[i].base < 0.2501) {
                EXPECT_NEAR(lobes[i].below.value_or(0) / wanted, 1, close);
            }
        }
    }
}

TEST(LabPlane, WhereNothingRisesThereIsNoLobe) {
    const BrdfProbe lambert = make_probe("lambert");
    for (const PlaneLobe& lobe : Plane(lambert).lobes({{0, 0}, {0, 1}})) {
        EXPECT_FALSE(lobe.any);
        EXPECT_FALSE(lobe.half_width());
        EXPECT_NEAR(lobe.peak, 0.25, 1e-6);
    }
    EXPECT_TRUE(std::isnan(measure_lobe_shapes(lambert, 1)[0].half_width));
}

TEST(LabPlane, ValuesAreEvalOverTheCosine) {
    const BrdfProbe probe = make_probe("phong");  // kd + ks c^n / cos
    const Plane plane(probe, 1.1);
    const std::vector<double> f =
        plane.luminances({{{0, 0.5}, 0.5}, {{0, 0.5}, 0.6}, {{0, 0}, -0.1}});
    EXPECT_NEAR(f[0], 0.25 + 0.25 / std::cos(0.5), 1e-5);
    EXPECT_NEAR(f[1], 0.25 + 0.25 * std::pow(std::cos(0.1), 100) / std::cos(0.6), 1e-5);
    EXPECT_NEAR(f[2], 0.25 + 0.25 * std::pow(std::cos(0.1), 99), 1e-5);
}

TEST(LabAlbedo, KnownValues) {
    BrdfProbe rational = make_probe("rational");
    // kd .25 / pi and specular albedo .5 at normal incidence, n = 100; kd = 0 at grazing.
    const Subject s = set_up(
        rational.model(),
        {{"", "normalize", "true"}, {"", "kd", "0.25"}, {"", "ks", "0.5"}, {"", "n", "100"}});
    rational.set_parameters({s.rows});
    const double wanted[] = {0.75, 0.607499, 0.374399, 0.324151};
    const double degrees[] = {0, 45, 80, 89};
    std::vector<AlbedoCase> cases;
    const Plane plane(rational);
    for (const double angle : degrees) cases.push_back({0, plane.viewer(glm::radians(angle))});
    const std::vector<Albedo> found = directional_albedos(rational, cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        EXPECT_NEAR(found[i].value.y, wanted[i], 2e-5) << degrees[i];
        EXPECT_LT(found[i].error, 1e-4);
    }
    const BrdfProbe mirror = make_probe("mirror");
    const Albedo reflected = directional_albedos(mirror, {{0, {0.6, 0, 0.8}}})[0];
    EXPECT_NEAR(reflected.value.x, 0.9, 1e-6);
    EXPECT_NEAR(reflected.mirror.x, 0.9, 1e-6);
}

// The lobe's own integral, in rings about the normal, against cubature over the hemisphere.
TEST(LabLobeShape, IntegralsAgreeWithCubatureOverTheHemisphere) {
    std::size_t seen = 0;
    for (const BrdfTable& model : read_brdf_tables(kernels())) {
        SCOPED_TRACE(model.name);
        const Subject subject = set_up(model, {});
        BrdfProbe probe(test_device(), kernels(), model);
        probe.set_parameters({subject.rows}, subject.tables);
        const LobeShape shape = measure_lobe_shapes(probe, 1)[0];
        if (!(shape.integral > 0)) continue;
        ++seen;
        const Albedo albedo = directional_albedos(probe, {{0, {0, 0, 1}}})[0];
        const double rings = pi * shape.base + (shape.peak - shape.base) * shape.albedo;
        EXPECT_NEAR(rings / luminance(albedo.value - albedo.mirror), 1, 1e-4);
        EXPECT_GT(shape.median, 0);
        EXPECT_LT(shape.median, pi / 2);
    }
    EXPECT_GE(seen, 4u);
}

// A Gaussian of different widths in x and y: its integral is not that of the plane of incidence.
TEST(LabLobeShape, AnisotropicLobesAreAveragedAllRound) {
    BrdfProbe probe = make_probe("conductor");
    const Subject s = set_up(probe.model(), {{"", "alpha_x", "0.1"}, {"", "alpha_y", "0.4"}});
    probe.set_parameters({s.rows});
    const LobeShape shape = measure_lobe_shapes(probe, 1)[0];
    const Albedo albedo = directional_albedos(probe, {{0, {0, 0, 1}}})[0];
    const double rings = pi * shape.base + (shape.peak - shape.base) * shape.albedo;
    EXPECT_NEAR(rings / luminance(albedo.value), 1, 1e-3);
}
