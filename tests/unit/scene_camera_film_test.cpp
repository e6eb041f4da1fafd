// SPDX-License-Identifier: Apache-2.0
// Camera, film, filter, sampler, integrator and lights.
#include <cmath>

#include "scene_test_support.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr double pi = 3.14159265358979323846;

Scene before(const std::string& lines, Dialect dialect = Dialect::v4) {
    ReadOptions options;
    options.dialect = dialect;
    return read_text(lines + "\nWorldBegin" + (dialect == Dialect::v3 ? " WorldEnd" : ""), options);
}
Scene before3(const std::string& lines) { return before(lines, Dialect::v3); }

}  // namespace

TEST(Settings, DefaultsAreTheDialects) {
    const Scene v3 = before3(""), v4 = before("");
    EXPECT_EQ(v3.film.width, 1280u);
    EXPECT_EQ(v3.film.height, 720u);
    EXPECT_EQ(v3.filter.kind, FilterKind::box);
    EXPECT_EQ(v3.filter.radius_x, .5);
    EXPECT_EQ(v4.film.width, 1280u);
    EXPECT_EQ(v4.film.height, 720u);
    EXPECT_EQ(v4.filter.kind, FilterKind::gaussian);
    EXPECT_EQ(v4.filter.radius_y, 1.5);
    EXPECT_EQ(v4.filter.alpha, 2);
    for (const Scene* scene : {&v3, &v4}) {
        EXPECT_EQ(scene->samples_per_pixel, 16u);
        EXPECT_EQ(scene->max_depth, 5u);
        EXPECT_EQ(scene->camera.fov, 90);
        EXPECT_EQ(scene->camera.focal_distance, 1e6);
    }
}

TEST(Settings, Filters) {
    const Filter gaussian3 = before3("PixelFilter \"gaussian\"").filter;
    EXPECT_EQ(gaussian3.radius_x, 2);
    EXPECT_EQ(gaussian3.alpha, 2);
    EXPECT_EQ(before("PixelFilter \"gaussian\" \"float sigma\" .25").filter.alpha, 8);
    EXPECT_EQ(before3("PixelFilter \"gaussian\" \"float alpha\" 3 \"float xwidth\" 4").filter.alpha,
              3);
    const Filter mitchell = before("PixelFilter \"mitchell\" \"float B\" .5").filter;
    EXPECT_EQ(mitchell.kind, FilterKind::mitchell);
    EXPECT_EQ(mitchell.b, .5);
    EXPECT_EQ(mitchell.c, 1.0 / 3);
    EXPECT_EQ(mitchell.radius_x, 2);
    const Filter triangle = before3("PixelFilter \"triangle\" \"float ywidth\" 1").filter;
    EXPECT_EQ(triangle.kind, FilterKind::triangle);
    EXPECT_EQ(triangle.radius_x, 2);
    EXPECT_EQ(triangle.radius_y, 1);
    EXPECT_EQ(before("PixelFilter \"box\"").filter.radius_x, .5);
    EXPECT_FAULT("PixelFilter \"sinc\" WorldBegin", "1:13", "understood but not supported yet");
    EXPECT_FAULT("PixelFilter \"bax\" WorldBegin", "1:13", "did you mean 'box'");
    EXPECT_FAULT("PixelFilter \"box\" \"float xradius\" 0 WorldBegin", "1:19", "has 0");
}

TEST(Settings, Film) {
    const FilmSettings film = before(
                                  "Film \"rgb\" \"integer xresolution\" 7 \"integer yresolution\" "
                                  "[9] \"string filename\" \"a.exr\" "
                                  "\"float cropwindow\" [.75 .25 0 2]")
                                  .film;
    EXPECT_EQ(film.width, 7u);
    EXPECT_EQ(film.height, 9u);
    EXPECT_EQ(film.filename, "a.exr");
    EXPECT_EQ(film.crop, (std::array<double, 4>{.25, .75, 0, 1}));
    EXPECT_FAULT("Film \"rgb\" \"integer xresolution\" 0 WorldBegin", "1:12", "has 0");
    EXPECT_FAULT("Film \"rgb\" \"float xresolution\" 1 WorldBegin", "1:12", "wants integer");
    EXPECT_FAULT("Film \"rgb\" \"float cropwindow\" [0 0 0 1] WorldBegin", "1:12", "empty");
    EXPECT_FAULT("Film \"rgb\" \"float cropwindow\" [0 1] WorldBegin", "1:12", "wants 4 numbers");
    EXPECT_FAULT("Film \"rgb\" \"float iso\" 200 WorldBegin", "1:12", "not supported yet");
    EXPECT_FAULT("Film \"spectral\" WorldBegin", "1:6", "not supported yet");
}

TEST(Settings, Camera) {
    const Camera camera = before(
                              "Camera \"perspective\" \"float fov\" 30 \"float lensradius\" .1 "
                              "\"float focaldistance\" 4 \"float screenwindow\" [-2 1 -1 3]")
                              .camera;
    EXPECT_EQ(camera.fov, 30);
    EXPECT_EQ(camera.lens_radius, .1);
    EXPECT_EQ(camera.focal_distance, 4);
    EXPECT_EQ(*camera.screen_window, (std::array<double, 4>{-2, 1, -1, 3}));
    const auto tall = before("Camera \"perspective\" \"float frameaspectratio\" .5").camera;
    EXPECT_EQ(*tall.screen_window, (std::array<double, 4>{-1, 1, -2, 2}));
    EXPECT_EQ(before3("Camera \"perspective\" \"float halffov\" 20").camera.fov, 40);
    EXPECT_FAULT("Camera \"perspective\" \"float fov\" 180 WorldBegin", "1:22", "fov");
    EXPECT_FAULT("Camera \"orthographic\" WorldBegin", "1:8", "not supported yet");
    EXPECT_FAULT("Camera \"perspective\" \"float lens\" 1 WorldBegin", "1:22", "unknown parameter");
}

TEST(Settings, SamplersAndIntegrators) {
    EXPECT_EQ(before("Sampler \"zsobol\" \"integer pixelsamples\" 77").samples_per_pixel, 77u);
    EXPECT_EQ(before3("Sampler \"random\"").samples_per_pixel, 4u);
    EXPECT_EQ(before("Sampler \"stratified\" \"integer xsamples\" 3").samples_per_pixel, 12u);
    EXPECT_EQ(before("Integrator \"volpath\" \"integer maxdepth\" 9").max_depth, 9u);
    EXPECT_EQ(before3("SurfaceIntegrator \"path\" \"integer maxdepth\" 0").max_depth, 0u);
    EXPECT_FAULT("Sampler \"halten\" WorldBegin", "1:9", "did you mean 'halton'");
    EXPECT_FAULT("Sampler \"halton\" \"integer pixelsamples\" 0 WorldBegin", "1:18", "has 0");
    EXPECT_FAULT("Integrator \"bdpt\" WorldBegin", "1:12", "not supported yet");
    EXPECT_FAULT("Integrator \"path\" \"integer maxdepth\" -1 WorldBegin", "1:19", "has -1");
}

TEST(Lights, PointAndDistant) {
    const Scene scene = read_text(
        world4("Translate 1 0 0 LightSource \"point\" \"rgb I\" [1 2 3] \"float scale\" 2 "
               "\"point3 from\" [0 1 0] LightSource \"point\" \"float power\" 100\n"
               "Rotate 90 0 0 1 LightSource \"distant\" \"rgb L\" [1 1 2] \"point3 from\" [5 0 0] "
               "\"point3 to\" [2 0 0] LightSource \"distant\" \"float illuminance\" 3"));
    EXPECT_EQ(scene.point_lights.at(0).intensity, glm::vec3(2, 4, 6));
    EXPECT_EQ(scene.point_lights[0].position, glm::dvec3(1, 1, 0));
    EXPECT_NEAR(scene.point_lights.at(1).intensity.x, 100 / (4 * pi), 1e-6);
    EXPECT_NEAR(scene.distant_lights.at(0).towards.y, 1, 1e-12);
    EXPECT_EQ(scene.distant_lights[0].irradiance, glm::vec3(1, 1, 2));
    EXPECT_NEAR(scene.distant_lights.at(1).towards.z, -1, 1e-12);
    EXPECT_EQ(scene.distant_lights[1].irradiance, glm::vec3(3));
}

TEST(Lights, Infinite) {
    const Scene scene = read_text(world3(
        "LightSource \"infinite\" \"rgb L\" [1 2 3] \"rgb scale\" [2 1 1] \"integer nsamples\" 4 "
        "LightSource \"infinite\""));
    EXPECT_EQ(*scene.environment, glm::vec3(3, 3, 4));
    EXPECT_FALSE(read_text(world3("")).environment.has_value());
    EXPECT_NEAR(
        read_text(world4("LightSource \"infinite\" \"float illuminance\" 1")).environment->x,
        1 / pi, 1e-7);
    EXPECT_FAULT(world3("LightSource \"infinite\" \"string mapname\" \"a.exr\""), "2:24",
                 "environment maps");
    EXPECT_FAULT(world3("LightSource \"spot\""), "2:13", "not supported yet");
    EXPECT_FAULT(world3("LightSource \"pont\""), "2:13", "did you mean 'point'");
    EXPECT_FAULT(world3("LightSource \"point\" \"rgb I\" [1 -1 1]"), "2:21", "has -1");
    EXPECT_FAULT(world3("LightSource \"distant\" \"point from\" [0 0 1]"), "2:1", "same point");
}

TEST(Lights, AreaLightsGoToShapes) {
    const Scene scene = read_text(
        world3("AreaLightSource \"area\" \"rgb L\" [1 2 3] \"rgb scale\" [2 2 2] \"bool twosided\" "
               "\"true\" \"integer nsamples\" 8 Shape \"sphere\""));
    EXPECT_EQ(scene.shapes[0].emission->radiance, glm::vec3(2, 4, 6));
    EXPECT_TRUE(scene.shapes[0].emission->two_sided);
    EXPECT_FAULT(world3("AreaLightSource \"aria\""), "2:17", "did you mean 'area'");
    EXPECT_FAULT(world4("AreaLightSource \"diffuse\" \"string filename\" \"a.exr\""), "2:27",
                 "not supported yet");
}

TEST(Lights, PowerGivesRadiance) {
    const auto radiance = [](const std::string& lines) {
        return read_text(world4("AreaLightSource \"diffuse\" \"float power\" 10 " + lines))
            .shapes.at(0)
            .emission->radiance.x;
    };
    EXPECT_NEAR(radiance("Shape \"sphere\" \"float radius\" 2"), 10 / (pi * 16 * pi), 1e-6);
    EXPECT_NEAR(radiance("Shape \"trianglemesh\" \"point3 P\" [0 0 0 2 0 0 0 3 0]"), 10 / (pi * 3),
                1e-6);
    EXPECT_NEAR(radiance("AreaLightSource \"diffuse\" \"float power\" 10 \"bool twosided\" true "
                         "Shape \"sphere\" \"float radius\" 2"),
                10 / (2 * pi * 16 * pi), 1e-6);
    // as in pbrt-v4 each triangle has the power
    EXPECT_NEAR(radiance("Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 1 1 0 0 1 0] "
                         "\"integer indices\" [0 1 2 0 2 3]"),
                10 / (pi * .5), 1e-5);
    EXPECT_FAULT(world4("AreaLightSource \"diffuse\" \"float power\" 1\nShape \"trianglemesh\" "
                        "\"point3 P\" [0 0 0 2 0 0 1 1 0 0 1 0] \"integer indices\" [0 1 2 0 2 3]"),
                 "2:1", "unequal triangles");
}

TEST(Lights, BlackbodiesAreNormalisedInVersion4Only) {
    const Scene v4 = read_text(world4("LightSource \"point\" \"blackbody I\" 6500"));
    const glm::vec3 c4 = v4.point_lights[0].intensity;
    EXPECT_NEAR(0.2126729 * c4.x + 0.7151522 * c4.y + 0.0721750 * c4.z, 1, 1e-4);
    EXPECT_NEAR(c4.x, c4.z, .12);  // near D65
    const Scene v3 = read_text(world3("LightSource \"point\" \"blackbody I\" [6500 2]"));
    const glm::vec3 c3 = v3.point_lights[0].intensity;
    EXPECT_NEAR(c3.x / c3.y, c4.x / c4.y, 1e-6);
    EXPECT_GT(c3.y, 1.7);  // near the peak of one, twice
    EXPECT_LT(c3.y, 2.0);
}
