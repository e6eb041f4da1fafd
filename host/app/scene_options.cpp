// SPDX-License-Identifier: Apache-2.0
#include "app/scene_options.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "app/numbers.h"
#include "app/user_models.h"
#include "base/error.h"
#include "base/log.h"
#include "scene/read.h"

namespace lobe {
namespace {

Error bad_option(const std::string& option, const std::string& value, const std::string& hint) {
    return Error(ExitCode::usage, option + " '" + value + "' is not understood", "", hint);
}

// Numbers separated by one character; throws unless there are exactly `count`.
std::vector<double> numbers(const std::string& option, const std::string& text, char separator,
                            std::size_t count, const std::string& hint) {
    std::vector<double> values;
    const char* at = text.data();
    const char* end = at + text.size();
    while (at != end) {
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || (next != end && (*next != separator || next + 1 == end)))
            throw bad_option(option, text, hint);
        values.push_back(value);
        at = next == end ? end : next + 1;
    }
    if (values.size() != count) throw bad_option(option, text, hint);
    return values;
}

void set_resolution(const std::string& text, FilmSettings& film) {
    const std::string hint = "write WIDTHxHEIGHT, e.g. 700x700";
    const auto v = numbers("--resolution", text, 'x', 2, hint);
    for (double size : v)
        if (size < 1 || size > 1e6 || size != static_cast<std::uint32_t>(size))
            throw bad_option("--resolution", text, hint);
    if (v[0] * v[1] > 0xffffffffu)
        throw bad_option("--resolution", text, "a film has at most 2^32 pixels");
    film.width = static_cast<std::uint32_t>(v[0]);
    film.height = static_cast<std::uint32_t>(v[1]);
}

void set_crop(const std::string& text, FilmSettings& film) {
    const std::string hint = "write X0,X1,Y0,Y1 as parts of the film from 0 to 1";
    const auto v = numbers("--crop", text, ',', 4, hint);
    if (!(0 <= v[0] && v[0] < v[1] && v[1] <= 1 && 0 <= v[2] && v[2] < v[3] && v[3] <= 1))
        throw bad_option("--crop", text, hint);
    film.crop = {v[0], v[1], v[2], v[3]};
}

bool parse_radius(const std::string& text, double& radius) {
    const char* end = text.data() + text.size();
    const auto [next, error] = std::from_chars(text.data(), end, radius);
    return error == std::errc() && next == end && radius > 0 && radius <= 64;
}

// NAME or NAME:RADIUS with the usual parameters of each.
void set_filter(const std::string& text, Filter& filter) {
    const std::string hint = "box, triangle, gaussian or mitchell, with a radius as in box:0.5";
    const std::size_t colon = text.find(':');
    const std::string name = text.substr(0, colon);
    Filter chosen;
    double radius;
    if (name == "box") {
        chosen.kind = FilterKind::box, radius = 0.5;
    } else if (name == "triangle") {
        chosen.kind = FilterKind::triangle, radius = 2;
    } else if (name == "gaussian") {
        chosen.kind = FilterKind::gaussian, radius = 1.5;
    } else if (name == "mitchell") {
        chosen.kind = FilterKind::mitchell, radius = 2;
    } else {
        throw bad_option("--filter", text, hint);
    }
    if (colon != std::string::npos && !parse_radius(text.substr(colon + 1), radius))
        throw bad_option("--filter", text, hint);
    chosen.radius_x = chosen.radius_y = radius;
    filter = chosen;
}

ReadOptions read_options(const SceneOptions& options) {
    ReadOptions read;
    read.lenient = options.lenient;
    if (options.dialect == "v3") read.dialect = Dialect::v3;
    if (options.dialect == "v4") read.dialect = Dialect::v4;
    for (const std::string& pair : options.replace) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == pair.size())
            throw bad_option("--replace", pair, "write TYPE=MODEL, e.g. plastic=rational");
        read.replace.emplace_back(pair.substr(0, equals), pair.substr(equals + 1));
    }
    if (options.replace_n && options.replace.empty())
        throw Error(ExitCode::usage, "--n has nothing to set", "",
                    "it goes with --replace TYPE=MODEL");
    read.replace_n = options.replace_n;
    return read;
}

// An option whose values are named in the order of its enumeration; the first is the default.
template <typename Choice>
void add_choice(CLI::App& verb, const std::string& name, Choice& choice,
                const std::vector<std::string>& values, const std::string& meaning) {
    const auto set = [&choice, values](const std::string& value) {
        const auto place = std::find(values.begin(), values.end(), value) - values.begin();
        choice = static_cast<Choice>(place);
    };
    verb.add_option_function<std::string>(name, set, meaning + " (" + values.front() + ")")
        ->check(CLI::IsMember(values));
}

void add_integrator_options(CLI::App& verb, Integrator& i) {
    add_choice(verb, "--sampler", i.sampler, {"sobol", "independent"}, "the random numbers");
    add_choice(verb, "--strategy", i.strategy, {"both", "light", "brdf"},
               "find shining shapes by sampling lights, by sampling reflection, or by both");
    add_choice(verb, "--heuristic", i.heuristic, {"power", "balance"},
               "how --strategy both weighs the two");
    add_choice(verb, "--directions", i.directions, {"matched", "cosine"},
               "sample each model's own lobes, or the cosine for all");
}

// What the choices leave out of a picture.
void warn_of_mirrors(const Integrator& integrator, const Scene& scene) {
    if (integrator.directions != Integrator::Directions::cosine) return;
    for (const Material& material : scene.materials)
        if (material.brdf == "mirror")
            warn("--directions cosine never meets a perfect mirror: it renders black",
                 material.where);
}

}  // namespace

void add_scene_options(CLI::App& verb, SceneOptions& o) {
    verb.add_option("scene", o.path, "a pbrt scene file, version 3 or 4")
        ->required()
        ->type_name("SCENE");
    verb.add_option("--spp", o.spp, "samples a pixel")
        ->transform(whole_number(1, 1u << 30))
        ->type_name("NUMBER");
    verb.add_option("--resolution", o.resolution, "film size")->type_name("WxH");
    verb.add_option("--crop", o.crop, "part of the film to render")->type_name("X0,X1,Y0,Y1");
    verb.add_option("--max-depth", o.max_depth, "most scattering events of a path")
        ->transform(whole_number(0, 1u << 20))
        ->type_name("NUMBER");
    verb.add_option("--filter", o.filter, "box, triangle, gaussian or mitchell")
        ->type_name("NAME[:RADIUS]");
    add_integrator_options(verb, o.integrator);
    verb.add_option("--dialect", o.dialect, "of the scene file")
        ->check(CLI::IsMember({"auto", "v3", "v4"}));
    verb.add_option("--features", o.features, "compile in what the scene needs, or all there is")
        ->check(CLI::IsMember({"auto", "all"}));
    verb.add_option("--brdf", o.brdfs, "a reflectance model of your own; may be repeated")
        ->type_name("FILE.cl");
    verb.add_flag("--trust-scene-kernels", o.trust_scene_kernels,
                  "run models whose files the scene itself names: they are programs");
    verb.add_option("--replace", o.replace, "render materials of a type with another model")
        ->type_name("TYPE=MODEL");
    verb.add_option("--n", o.replace_n,
                    "n of the models that --replace puts in (else the scene's, else 100)")
        ->check(real_number(0, std::numeric_limits<double>::infinity(), "from 0 to inf"))
        ->type_name("NUMBER");
    verb.add_flag("--lenient", o.lenient,
                  "warn of unknown directives and parameters instead of failing");
}

namespace {

void apply(const SceneOptions& o, Scene& scene) {
    if (!o.resolution.empty()) set_resolution(o.resolution, scene.film);
    if (!o.crop.empty()) set_crop(o.crop, scene.film);
    if (!o.filter.empty()) set_filter(o.filter, scene.filter);
    if (o.spp) scene.samples_per_pixel = *o.spp;
    if (o.max_depth) scene.max_depth = *o.max_depth;
}

}  // namespace

Scene read_scene_for(const SceneOptions& o, KernelText& kernels) {
    const ReadOptions read = read_options(o);
    Scene none;
    apply(o, none);  // a bad option is told before a long scene is read
    add_user_models(kernels, o.brdfs);
    Scene scene = read_scene(o.path, read_brdf_tables(kernels), read);
    for (const UserModel& model : scene.models) kernels.add(model.table.file, model.text);
    apply(o, scene);
    for (const std::string& warning : scene.warnings) warn(warning);
    warn_of_mirrors(o.integrator, scene);
    return scene;
}

}  // namespace lobe
