// SPDX-License-Identifier: Apache-2.0
#include "lab/hemisphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/random.h"

using namespace lobe;

namespace {

constexpr double pi = glm::pi<double>();

using Function = std::function<double(const glm::dvec3&)>;

HemisphereJob integral(const Function& f, std::vector<PilotPoint> pilot = {}) {
    Random random(1);
    while (pilot.size() < 500)
        pilot.push_back({random.uniform(0, pi / 2), random.uniform(-pi, pi), 0});
    const HemisphereCells cells(std::move(pilot), 32);
    std::vector<HemisphereJob> jobs(1);
    jobs[0].patches = cells.patches();
    jobs[0].pilot = cells.pilot();
    integrate(jobs, [&](const HemisphereNodes& nodes) {
        std::vector<HemisphereJob::Values> values;
        for (const glm::dvec3& d : nodes.directions) values.push_back({f(d), 0, 0, 0, 0});
        return values;
    });
    return jobs[0];
}

void expect_integral(const Function& f, double exact, std::vector<PilotPoint> pilot = {}) {
    const HemisphereJob job = integral(f, std::move(pilot));
    EXPECT_NEAR(job.total[0] / exact, 1, 2e-5);
    EXPECT_LE(job.error[0], 2.1e-5 * exact);
}

// A lobe of exponent n about a direction, whose integral over the sphere is 2 pi / (n + 1).
Function lobe_about(const glm::dvec3& axis, double n) {
    return [axis, n](const glm::dvec3& d) {
        const double x = 0.5 * glm::dot(axis - d, axis - d);
        return x < 1 ? std::exp(n * std::log1p(-x)) : 0;
    };
}

}  // namespace

TEST(LabHemisphere, CoordinatesGoBothWays) {
    for (const double elevation : {1e-12, 0.3, 1.5})
        for (const double azimuth : {-3.0, -0.5, 0.0, 2.0}) {
            const glm::dvec3 d = direction_at(elevation, azimuth + 0.7);
            EXPECT_NEAR(glm::length(d), 1, 1e-15);
            const glm::dvec2 back = elevation_azimuth(d, 0.7);
            EXPECT_NEAR(back.x / elevation, 1, 1e-10);
            EXPECT_NEAR(back.y, azimuth, 1e-10);
        }
}

TEST(LabHemisphere, ClosedForms) {
    expect_integral([](const glm::dvec3&) { return 1; }, 2 * pi);
    expect_integral([](const glm::dvec3& d) { return d.z; }, pi);
    expect_integral([](const glm::dvec3& d) { return d.x * d.x * d.z; }, pi / 4);
    expect_integral(lobe_about({0, 0, 1}, 1000), 2 * pi / 1001);
}

// A jump within patches and across borders.
TEST(LabHemisphere, LobesThatEndAbruptly) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.9, 0.1, 0.3));
    const Function half = [&](const glm::dvec3& d) { return glm::dot(axis, d) > 0 ? 1.0 : 0.0; };
    // The lune between the horizon and a plane through the origin: pi + 2 asin(axis.z) of 2 pi.
    EXPECT_NEAR(integral(half).total[0], pi + 2 * std::asin(axis.z), 1e-3);
}

// Peaks a thousand times smaller than a cell are found by what the pilot says of them.
TEST(LabHemisphere, SharpLobesAreFoundByThePilot) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.6, -0.5, 0.4));
    const double n = 1e7;
    const Function lobe = lobe_about(axis, n);
    Random random(2);
    std::vector<PilotPoint> pilot;
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 near = glm::normalize(
            axis + random.log_uniform(1e-5, 3e-3) *
                       glm::dvec3(random.normal(), random.normal(), random.normal()));
        pilot.push_back({elevation_azimuth(near, 0), lobe(near)});
    }
    expect_integral(lobe, 2 * pi / (n + 1), pilot);
    EXPECT_LT(integral(lobe).total[0], 1e-9) << "without a pilot nobody would have seen it";
}

TEST(LabHemisphere, CellsHoldTheirPointsAndTheirIntegrals) {
    Random random(3);
    std::vector<PilotPoint> pilot;
    for (int i = 0; i < 1000; ++i)
        pilot.push_back({random.uniform(0, pi / 2), random.uniform(-pi, pi), 0});
    const HemisphereCells cells(pilot, 50);
    EXPECT_GE(cells.count(), 50u);
    double covered = 0;
    for (const Patch& patch : cells.patches()) {
        const glm::dvec2 size = patch.high - patch.low;
        covered += size.x * size.y;
        EXPECT_EQ(cells.cell_of(0.5 * (patch.low + patch.high)), patch.cell);
        EXPECT_LE(patch.count, 1000u / 50);
    }
    EXPECT_NEAR(covered, pi * pi, 1e-9);
    std::vector<HemisphereJob> jobs(1);
    jobs[0].patches = cells.patches();
    jobs[0].pilot = cells.pilot();
    integrate(jobs, [](const HemisphereNodes& nodes) {
        return std::vector<HemisphereJob::Values>(nodes.directions.size(), {1, 2, 3, 4, 5});
    });
    for (const Patch& patch : cells.patches()) {
        const double area =
            (std::sin(patch.high.x) - std::sin(patch.low.x)) * (patch.high.y - patch.low.y);
        for (int k = 0; k < HemisphereJob::values; ++k)
            EXPECT_NEAR(jobs[0].by_cell[patch.cell][k], (k + 1) * area, 1e-9);
    }
}
