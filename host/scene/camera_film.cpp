// SPDX-License-Identifier: Apache-2.0
// Defaults: the file formats and sources of pbrt-v3 and pbrt-v4, which differ in them.
#include "scene/camera_film.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/parameters.h"

namespace lobe {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double tiny = std::numeric_limits<double>::min();

// Fails unless the directive's class is one of `known`; tells those of `later` from typing errors.
void check_class(const Statement& statement, const std::vector<std::string>& known,
                 const std::vector<std::string>& later) {
    const Word& kind = statement.strings[0];
    if (std::find(known.begin(), known.end(), kind.text) == known.end())
        fail_class(kind.place, statement.name, kind.text, known, later);
}

// Fails if the file gives a parameter another value than the one that changes nothing.
void refuse_unless(Parameters& p, const char* name, double neutral) {
    const Parameter* given = p.find({name});
    if (given && p.number_of(*given, true) != neutral) p.refuse({name});
}

// x0 x1 y0 y1, or nothing.
std::optional<std::array<double, 4>> four_numbers(Parameters& p, const char* name) {
    const Parameter* given = p.list({name}, {ParameterType::number, ParameterType::integer});
    if (!given) return {};
    if (given->numbers.size() != 4)
        fail(given->place, "parameter \"" + given->name + "\" wants 4 numbers, has " +
                               std::to_string(given->numbers.size()));
    return std::array<double, 4>{given->numbers[0], given->numbers[1], given->numbers[2],
                                 given->numbers[3]};
}

std::uint32_t count(Parameters& p, const char* name, int standard, int lowest) {
    const int value = p.integer({name}, standard);
    p.check_range(value, lowest, 2147483647);
    return static_cast<std::uint32_t>(value);
}

void read_screen(Parameters& p, Camera& camera) {
    camera.screen_window = four_numbers(p, "screenwindow");
    if (camera.screen_window) {
        const auto& window = *camera.screen_window;
        if (!(window[0] < window[1] && window[2] < window[3]))
            fail(p.last_place(), "the screen window is empty", "it is [ left right bottom top ]");
    }
    if (const Parameter* given = p.find({"frameaspectratio"})) {
        const double aspect = p.number_of(*given);
        p.check_range(aspect, tiny, inf);
        const double x = std::max(aspect, 1.0), y = std::max(1 / aspect, 1.0);
        if (!camera.screen_window) camera.screen_window = {-x, x, -y, y};
    }
}

}  // namespace

void set_defaults(Scene& scene) {
    const bool v4 = scene.dialect == Dialect::v4;
    scene.film.width = 1280;
    scene.film.height = 720;
    scene.filter = {};
    if (v4) scene.filter = {FilterKind::gaussian, 1.5, 1.5, 2.0};
    scene.samples_per_pixel = 16;
    scene.max_depth = 5;
}

void read_camera(const Statement& statement, const glm::dmat4& world_to_camera,
                 ReadContext& context) {
    check_class(statement, {"perspective"},
                {"orthographic", "environment", "spherical", "realistic"});
    Parameters p(statement, context);
    Camera& camera = context.scene.camera;
    camera = {};
    camera.camera_to_world = glm::inverse(world_to_camera);
    camera.fov = p.number({"fov"}, 90);
    if (p.find({"fov"})) p.check_range(camera.fov, tiny, 179.999);
    if (const Parameter* half = p.find({"halffov"})) {
        camera.fov = 2 * p.number_of(*half);
        p.check_range(camera.fov / 2, tiny, 89.9995);
    }
    camera.lens_radius = p.number({"lensradius"}, 0);
    p.check_range(camera.lens_radius, 0, inf);
    camera.focal_distance = p.number({"focaldistance"}, 1e6);
    p.check_range(camera.focal_distance, tiny, inf);
    read_screen(p, camera);
    p.ignore({"shutteropen", "shutterclose"});
    p.finish();
}

void read_film(const Statement& statement, ReadContext& context) {
    check_class(statement, {"image", "rgb", "gbuffer"}, {"spectral"});
    Parameters p(statement, context);
    FilmSettings& film = context.scene.film;
    film.width = count(p, "xresolution", static_cast<int>(film.width), 1);
    film.height = count(p, "yresolution", static_cast<int>(film.height), 1);
    film.filename = p.text({"filename"}, "");
    if (const auto crop = four_numbers(p, "cropwindow")) {
        const auto& c = *crop;
        const auto unit = [](double v) { return std::min(std::max(v, 0.0), 1.0); };
        film.crop = {unit(std::min(c[0], c[1])), unit(std::max(c[0], c[1])),
                     unit(std::min(c[2], c[3])), unit(std::max(c[2], c[3]))};
        if (!(film.crop[0] < film.crop[1] && film.crop[2] < film.crop[3]))
            fail(p.last_place(), "the crop window is empty",
                 "it is [ x0 x1 y0 y1 ] within 0 and 1");
    }
    p.refuse({"pixelbounds"}, "use cropwindow");
    p.ignore({"diagonal", "savefp16", "coordinatesystem"});
    refuse_unless(p, "scale", 1);
    refuse_unless(p, "iso", 100);
    refuse_unless(p, "exposuretime", 1);
    refuse_unless(p, "whitebalance", 0);
    refuse_unless(p, "maxsampleluminance", inf);
    refuse_unless(p, "maxcomponentvalue", inf);
    if (p.text({"sensor"}, "cie1931") != "cie1931") p.refuse({"sensor"}, "use \"cie1931\"");
    p.finish();
}

void read_filter(const Statement& statement, ReadContext& context) {
    check_class(statement, {"box", "gaussian", "mitchell", "triangle"}, {"sinc"});
    Parameters p(statement, context);
    Filter& filter = context.scene.filter;
    const std::string& kind = statement.strings[0].text;
    const bool v4 = context.v4();
    filter = {};
    double radius = 2;
    if (kind == "box") radius = 0.5;
    if (kind == "triangle") filter.kind = FilterKind::triangle;
    if (kind == "mitchell") {
        filter.kind = FilterKind::mitchell;
        filter.b = p.number({"B"}, 1.0 / 3);
        filter.c = p.number({"C"}, 1.0 / 3);
    }
    if (kind == "gaussian") {
        filter.kind = FilterKind::gaussian;
        radius = v4 ? 1.5 : 2;
        const double sigma = p.number({"sigma"}, 0.5);
        if (p.find({"sigma"})) p.check_range(sigma, 1e-6, inf);
        const bool by_sigma = v4 || p.find({"sigma"});
        filter.alpha = p.number({"alpha"}, by_sigma ? 1 / (2 * sigma * sigma) : 2);
        p.check_range(filter.alpha, tiny, inf);
    }
    filter.radius_x = p.number({"xradius", "xwidth"}, radius);
    p.check_range(filter.radius_x, 1e-6, 1024);
    filter.radius_y = p.number({"yradius", "ywidth"}, radius);
    p.check_range(filter.radius_y, 1e-6, 1024);
    p.finish();
}

void read_sampler(const Statement& statement, ReadContext& context) {
    const std::vector<std::string> four{"random", "independent"};
    const std::vector<std::string> sixteen{"halton",         "sobol",      "zerotwosequence",
                                           "lowdiscrepancy", "02sequence", "maxmindist",
                                           "paddedsobol",    "zsobol",     "pmj02bn"};
    std::vector<std::string> known = sixteen;
    known.insert(known.end(), four.begin(), four.end());
    known.push_back("stratified");
    check_class(statement, known, {"adaptive", "bestcandidate"});
    Parameters p(statement, context);
    const std::string& kind = statement.strings[0].text;
    if (kind == "stratified") {
        const double samples = static_cast<double>(count(p, "xsamples", 4, 1)) *
                               static_cast<double>(count(p, "ysamples", 4, 1));
        if (samples > 2147483647) fail(statement.place, "too many samples per pixel");
        context.scene.samples_per_pixel = static_cast<std::uint32_t>(samples);
    } else {
        const bool few = std::find(four.begin(), four.end(), kind) != four.end();
        context.scene.samples_per_pixel = count(p, "pixelsamples", few ? 4 : 16, 1);
    }
    p.ignore({"jitter", "dimensions", "seed", "randomization", "samplepixelcenter"});
    p.finish();
}

void read_integrator(const Statement& statement, ReadContext& context) {
    check_class(statement, {"path", "volpath"},
                {"directlighting", "whitted", "ao", "ambientocclusion", "bdpt", "mlt", "sppm",
                 "function", "lightpath", "randomwalk", "simplepath", "simplevolpath", "igi",
                 "irradiancecache", "photonmap"});
    Parameters p(statement, context);
    context.scene.max_depth = count(p, "maxdepth", 5, 0);
    p.ignore({"rrthreshold", "lightsamplestrategy", "lightsampler"});
    if (p.flag({"regularize"}, false)) p.refuse({"regularize"});
    p.refuse({"pixelbounds"}, "use the film's cropwindow");
    p.finish();
}

}  // namespace lobe
