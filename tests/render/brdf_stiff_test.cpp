// SPDX-License-Identifier: Apache-2.0
// Stiff materials in pictures: the sharpest lobes under tiny lights, in float against double, and
// lobes that reach below the surface. No status counter may be raised (render_picture checks that).
#include <gtest/gtest.h>

#include <cmath>

#include "support/device.h"
#include "support/meshes.h"
#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

Material rational(float n, float kd, float ks) {
    return material("rational", {{"n", n}, {"kd", kd}, {"ks", ks}, {"normalize", 1}});
}

// A floor of n = 1e8 that mirrors a lamp of half angle radius / 2.8, seen from close enough that
// the core of the highlight, 1e-4 rad wide, fills some pixels.
Scene tiny_lamp(double radius) {
    Scene scene = small_scene(0.5, 48, 0.1);
    scene.max_depth = 2;
    scene.materials = {rational(1e8, 0.05, 0.9)};
    add(scene, rectangle({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}));
    shine(add(scene, {2, 0, 2}, radius), 1 / (radius * radius));
    look(scene, {-2, 0, 2}, {0, 0, 0});
    return scene;
}

bool all_finite(const Picture& picture) {
    for (const double value : picture.film.sums().radiance)
        if (!std::isfinite(value)) return false;
    return true;
}

// The mean of a - b, two pictures of the same random numbers, with its standard error.
MeanOf mean_of_difference(const Picture& a, const Picture& b) {
    const FilmSums x = a.film.sums(), y = b.film.sums();
    const double each = double(x.samples[0]) / LOBE_REPLICATES;
    MeanOf result;
    double squares = 0;
    const std::size_t pixels = x.radiance.size() / (3 * LOBE_REPLICATES);
    for (std::size_t p = 0; p < pixels; ++p) {
        double sum = 0, of_squares = 0;
        for (std::size_t k = 0; k < LOBE_REPLICATES; ++k) {
            const std::size_t i = (p * LOBE_REPLICATES + k) * 3;
            const double d = (x.radiance[i] - y.radiance[i]) / each;
            sum += d;
            of_squares += d * d;
        }
        const double mean = sum / LOBE_REPLICATES;
        result.mean += mean / double(pixels);
        squares += (of_squares - sum * mean) / (LOBE_REPLICATES - 1) / LOBE_REPLICATES;
    }
    result.error = std::sqrt(squares) / double(pixels);
    return result;
}

}  // namespace

TEST(BrdfStiff, SharpestLobeUnderATinyLamp) {
    LOBE_NEEDS_DOUBLE();
    for (const double radius : {1e-3, 1e-5}) {
        const Scene scene = tiny_lamp(radius);
        PictureOptions options;
        options.samples = 64;
        options.general = false;
        const Picture single = render_picture(scene, options);
        options.double_precision = true;
        const Picture twice = render_picture(scene, options);
        options.seed = 2;
        const Picture other = render_picture(scene, options);
        EXPECT_TRUE(all_finite(single));
        const MeanOf a = mean_of(single), b = mean_of(twice), c = mean_of(other);
        const MeanOf d = mean_of_difference(single, twice);
        std::printf(
            "  radius %g: float %.6g +- %.2g, double %.6g +- %.2g, of other numbers %.6g +- "
            "%.2g; float - double %.2g +- %.2g\n",
            radius, a.mean, a.error, b.mean, b.error, c.mean, c.error, d.mean, d.error);
        EXPECT_GT(a.mean, 20 * a.error);
        EXPECT_LT(std::abs(a.mean - b.mean), 3 * std::hypot(a.error, b.error)) << radius;
        EXPECT_LT(std::abs(a.mean - c.mean), 3 * std::hypot(a.error, c.error)) << radius;
        // With the same numbers the noise is gone: what is left are float's directions, 6e-8 beside
        // a lobe 1e-4 wide.
        EXPECT_LT(std::abs(d.mean), 1e-4 * b.mean + 3 * d.error) << radius;
    }
}

// Where interpolated normals turn the mirror direction below the surface, what lies below gives no
// light, and the rest stays a picture.
TEST(BrdfStiff, LobesBelowTheSurface) {
    for (const double n : {0.0, 10.0, 1e8, double(INFINITY)}) {
        Scene scene = small_scene(0.5, 16, 10);
        scene.materials = {rational(n, 0.25, 0.7)};
        Mesh floor = rectangle({-5, -5, 0}, {10, 0, 0}, {0, 10, 0});
        const double tilt = 50 * 3.14159265358979323846 / 180;
        floor.normals.assign(4, glm::vec3(std::sin(tilt), 0, std::cos(tilt)));
        add(scene, floor);
        look(scene, {-0.17, 0, 1}, {0, 0, 0});
        Scene below = scene;
        shine(add(below, rectangle({-50, -50, -1}, {100, 0, 0}, {0, 100, 0})), 100, true);
        EXPECT_EQ(mean_of(render_picture(below)).mean, 0) << n;
        below.distant_lights.push_back({{0, 0, -1}, glm::vec3(1)});
        EXPECT_EQ(mean_of(render_picture(below)).mean, 0) << n;
        scene.environment = glm::vec3(1);
        scene.max_depth = 1;
        const Picture under_sky = render_picture(scene);
        EXPECT_TRUE(all_finite(under_sky));
        EXPECT_GT(mean_of(under_sky).mean, 0.05) << n;
        EXPECT_LT(mean_of(under_sky).mean, 0.95) << n;
    }
}
