// SPDX-License-Identifier: Apache-2.0
// Pixel filters keep what they should keep: an even picture, and the slope of an uneven one.
#include <gtest/gtest.h>

#include <cmath>

#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double tests = 12;

const std::vector<std::pair<const char*, Filter>> filters = {
    {"box", {FilterKind::box, 0.5, 0.5}},
    {"triangle", {FilterKind::triangle, 2, 2}},
    {"gaussian", {FilterKind::gaussian, 2, 2, 2}},
    {"mitchell", {FilterKind::mitchell, 2, 2}}};

}  // namespace

TEST(PixelFilter, EvenPicturesStayEven) {
    for (const auto& [name, filter] : filters) {
        Scene scene = small_scene(0.5);
        scene.environment = glm::vec3(1);
        scene.filter = filter;
        const MeanOf mean = mean_of(render_picture(scene, {256}));
        EXPECT_TRUE(agrees(mean, 1, tests, 5e-5)) << name;
        EXPECT_LT(mean.error, 1e-3) << name;
    }
}

// Radiance that falls linearly across the film is, in each pixel, that of its middle: half a wall
// is lit by a light so far away that its cosine changes linearly over the narrow view.
TEST(PixelFilter, SlopesKeepTheirMiddle) {
    for (const auto& [name, filter] : filters) {
        Scene scene = small_scene(0.5, 32, 20);
        scene.max_depth = 1;
        add(scene, wall(5, 40));
        scene.point_lights.push_back({{40, 0, -20}, glm::vec3(3000)});
        scene.filter = filter;
        const Picture picture = render_picture(scene, {256});
        // Columns 4 and 27: symmetrical, far from the film's border, which no filter knows of.
        const auto column = [&](std::uint32_t x) {
            const double at = (2 * (x + 0.5) / 32 - 1) * std::tan(0.17453292519943295) * 5;
            double sum = 0;
            for (int y = 0; y < 32; ++y) {
                const double up = (1 - 2 * (y + 0.5) / 32) * std::tan(0.17453292519943295) * 5;
                const glm::dvec3 way = glm::dvec3(40, 0, -20) - glm::dvec3(at, up, 5);
                const double squared = glm::dot(way, way);
                sum += 0.5 / 3.14159265358979 * 3000 * 25 / (squared * std::sqrt(squared));
            }
            return sum / 32;
        };
        for (const std::uint32_t x : {4u, 27u})
            EXPECT_TRUE(
                agrees(mean_of(picture, 0, Region{x, 0, x + 1, 32}), column(x), tests, 1e-4))
                << name << ", column " << x;
    }
}
