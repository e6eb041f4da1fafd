// SPDX-License-Identifier: Apache-2.0
// What must not change a bit of the picture, and what must.
#include <gtest/gtest.h>

#include "support/render_rig.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

PictureOptions short_render() {
    PictureOptions options;
    options.samples = 12;  // a whole block and a half
    options.general = false;
    return options;
}

}  // namespace

TEST(Determinism, RerunsGiveTheSameBits) {
    const Scene scene = busy_scene(37, true);
    const std::string first = render_picture(scene, short_render()).hash;
    EXPECT_EQ(render_picture(scene, short_render()).hash, first);
    PictureOptions other = short_render();
    other.seed = 2;
    EXPECT_NE(render_picture(scene, other).hash, first);
    other.seed = 1ull << 32 | 1;
    EXPECT_NE(render_picture(scene, other).hash, first);
}

TEST(Determinism, WorkGroupsChangeNothing) {
    const Scene scene = busy_scene(37, true);
    PictureOptions options = short_render();
    const std::string first = render_picture(scene, options).hash;
    for (const std::array<unsigned, 2> local :
         {std::array<unsigned, 2>{1, 1}, {16, 4}, {64, 1}, {3, 5}}) {
        options.local = local;
        EXPECT_EQ(render_picture(scene, options).hash, first) << local[0] << "x" << local[1];
    }
}

TEST(Determinism, LaunchesChangeNothing) {
    const Scene scene = busy_scene(37, true);
    PictureOptions options = short_render();
    const std::string first = render_picture(scene, options).hash;
    for (const std::uint32_t tiles : {1u, 2u, 5u, 9u, 64u}) {
        options.tiles_per_launch = tiles;
        EXPECT_EQ(render_picture(scene, options).hash, first) << tiles << " tiles a launch";
    }
}

TEST(Determinism, LanesChangeNothing) {
    for (const bool lens : {true, false}) {
        Scene scene = busy_scene(37, true);
        if (!lens) scene.camera.lens_radius = 0;
        PictureOptions options = short_render();
        options.abreast = 1;
        const std::string first = render_picture(scene, options).hash;
        options.abreast = 8;
        EXPECT_EQ(render_picture(scene, options).hash, first);
    }
}

// The general kernel and those that leave out what a scene does not need.
TEST(Determinism, FeaturesChangeNothing) {
    std::vector<std::pair<const char*, Scene>> scenes;
    scenes.emplace_back("all but the filter", busy_scene(29, true));
    scenes.emplace_back("no sky", busy_scene(29, false));
    Scene filtered = busy_scene(29, false);
    filtered.filter = {FilterKind::mitchell, 2, 2};
    scenes.emplace_back("mitchell", filtered);
    Scene pinhole = busy_scene(29, true);
    pinhole.camera.lens_radius = 0;
    pinhole.point_lights.clear();
    scenes.emplace_back("pinhole, no point", pinhole);
    Scene balls = small_scene(0.5, 29);
    balls.environment = glm::vec3(1);
    add(balls, {0, 0, 4}, 1);
    shine(add(balls, {1, 1, 3}, 0.3), 4);
    scenes.emplace_back("spheres only", balls);
    Scene faces = small_scene(0.5, 29);
    add(faces, wall(4, 3));
    shine(add(faces, wall(2, 0.2)), 4, true);
    scenes.emplace_back("triangles only", faces);
    for (const auto& [name, scene] : scenes) {
        PictureOptions options = short_render();
        const std::string derived = render_picture(scene, options).hash;
        options.general = true;
        EXPECT_EQ(render_picture(scene, options).hash, derived) << name;
    }
}

TEST(Determinism, CropIsPartOfTheWhole) {
    Scene scene = busy_scene(40, true);
    const FilmSums whole = render_picture(scene, short_render()).film.sums();
    scene.film.crop = {0.25, 0.75, 0.1, 0.6};
    const Picture part = render_picture(scene, short_render());
    ASSERT_EQ(part.film.width(), 20u);
    ASSERT_EQ(part.film.height(), 20u);
    const FilmSums crop = part.film.sums();
    const std::size_t row = LOBE_REPLICATES * 3;
    for (std::size_t y = 0; y < 20; ++y)
        for (std::size_t x = 0; x < 20; ++x)
            for (std::size_t k = 0; k < row; ++k)
                ASSERT_EQ(crop.radiance[(y * 20 + x) * row + k],
                          whole.radiance[((y + 4) * 40 + x + 10) * row + k])
                    << "at " << x << ", " << y;
}

// A longer render begins with the shorter one: its first block is the same.
TEST(Determinism, SamplesAreWhatTheirNumberSays) {
    const Scene scene = busy_scene(16, true);
    PictureOptions options = short_render();
    options.samples = 8;
    const FilmSums eight = render_picture(scene, options).film.sums();
    options.samples = 16;
    const FilmSums sixteen = render_picture(scene, options).film.sums();
    double first = 0, both = 0;
    std::size_t repeated = 0;
    for (std::size_t i = 0; i < eight.radiance.size(); ++i) {
        EXPECT_GE(sixteen.radiance[i], eight.radiance[i]);  // radiance is never negative
        repeated += sixteen.radiance[i] == 2 * eight.radiance[i];
        first += eight.radiance[i];
        both += sixteen.radiance[i];
    }
    EXPECT_NEAR(both / first, 2, 0.1);
    EXPECT_LT(repeated, eight.radiance.size() / 10);  // the second block has samples of its own
}

// The picture is a matter of proportions: no constant of the code has a length in it.
TEST(Determinism, ScalingByAPowerOfTwoChangesNothing) {
    const Scene scene = busy_scene(32, true);
    const std::string first = render_picture(scene, short_render()).hash;
    for (const double scale : {0x1p-20, 0.5, 0x1p+20}) {
        Scene scaled = scene;
        for (Shape& shape : scaled.shapes) {
            if (auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
                for (glm::dvec3& p : mesh->positions) p *= scale;
            } else {
                auto& sphere = std::get<Sphere>(shape.geometry);
                sphere.centre *= scale;
                sphere.radius *= scale;
            }
        }
        for (PointLight& light : scaled.point_lights) {
            light.position *= scale;
            light.intensity *= float(scale * scale);
        }
        scaled.camera.camera_to_world[3] =
            glm::dvec4(scale * glm::dvec3(scaled.camera.camera_to_world[3]), 1);
        scaled.camera.lens_radius *= scale;
        scaled.camera.focal_distance *= scale;
        EXPECT_EQ(render_picture(scaled, short_render()).hash, first) << "scale " << scale;
    }
}

TEST(Determinism, TwiceTheLightIsTwiceThePicture) {
    const Scene scene = busy_scene(32, true);
    const FilmSums once = render_picture(scene, short_render()).film.sums();
    Scene bright = scene;
    for (Shape& shape : bright.shapes)
        if (shape.emission) shape.emission->radiance *= 2.0f;
    for (PointLight& light : bright.point_lights) light.intensity *= 2.0f;
    for (DistantLight& light : bright.distant_lights) light.irradiance *= 2.0f;
    *bright.environment *= 2.0f;
    const FilmSums twice = render_picture(bright, short_render()).film.sums();
    for (std::size_t i = 0; i < once.radiance.size(); ++i)
        ASSERT_EQ(twice.radiance[i], 2 * once.radiance[i]) << "sum " << i;
}

// Turning the whole scene, camera and all, gives another rounding but the same picture.
TEST(Determinism, MovingAndTurningAllIsOnlyNoise) {
    const Scene scene = busy_scene(32, true);
    Scene moved = scene;
    const glm::dmat4 turn = {{0, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 0, 0}, {300, -200, 70, 1}};
    const auto point = [&](const glm::dvec3& p) { return glm::dvec3(turn * glm::dvec4(p, 1)); };
    const auto vector = [&](const glm::dvec3& v) { return glm::dvec3(turn * glm::dvec4(v, 0)); };
    for (Shape& shape : moved.shapes) {
        if (auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
            for (glm::dvec3& p : mesh->positions) p = point(p);
            for (glm::vec3& n : mesh->normals) n = glm::vec3(vector(glm::dvec3(n)));
        } else {
            auto& sphere = std::get<Sphere>(shape.geometry);
            sphere.centre = point(sphere.centre);
        }
    }
    for (PointLight& light : moved.point_lights) light.position = point(light.position);
    for (DistantLight& light : moved.distant_lights) light.towards = vector(light.towards);
    moved.camera.camera_to_world = turn * moved.camera.camera_to_world;
    PictureOptions options = short_render();
    options.samples = 64;
    EXPECT_TRUE(blocks_agree(render_picture(scene, options), render_picture(moved, options), 1));
}
