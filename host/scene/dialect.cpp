// SPDX-License-Identifier: Apache-2.0
#include "scene/dialect.h"

#include <algorithm>
#include <set>

#include "base/error.h"

namespace lobe {

namespace {

using Pair = std::pair<std::string, std::string>;

const std::set<std::string> v3_directives{"WorldEnd", "SurfaceIntegrator", "VolumeIntegrator",
                                          "Renderer", "Volume"};
const std::set<std::string> v4_directives{"Import", "Option", "ColorSpace", "Attribute"};

const std::set<Pair> v3_classes{
    {"Film", "image"},
    {"AreaLightSource", "area"},
    {"Integrator", "directlighting"},
    {"Integrator", "whitted"},
    {"Sampler", "random"},
    {"Sampler", "02sequence"},
    {"Sampler", "zerotwosequence"},
    {"Sampler", "lowdiscrepancy"},
    {"Sampler", "maxmindist"},
    {"Camera", "environment"},
};
const std::set<Pair> v4_classes{
    {"Film", "rgb"},           {"Film", "gbuffer"},        {"Film", "spectral"},
    {"Camera", "spherical"},   {"Sampler", "independent"}, {"Sampler", "paddedsobol"},
    {"Sampler", "zsobol"},     {"Sampler", "pmj02bn"},     {"Integrator", "simplepath"},
    {"Shape", "bilinearmesh"},
};

const std::set<std::string> v3_materials{"matte",  "plastic", "metal",       "mirror",
                                         "glass",  "uber",    "substrate",   "translucent",
                                         "disney", "fourier", "kdsubsurface"};
const std::set<std::string> v4_materials{
    "diffuse",    "coateddiffuse",  "conductor",           "coatedconductor",
    "dielectric", "thindielectric", "diffusetransmission", "interface"};

const std::set<Pair> v3_parameters{
    {"PixelFilter", "xwidth"},      {"PixelFilter", "ywidth"},
    {"PixelFilter", "alpha"},       {"LightSource", "mapname"},
    {"Shape", "nlevels"},           {"LightSource", "nsamples"},
    {"LightSource", "samples"},     {"AreaLightSource", "nsamples"},
    {"AreaLightSource", "samples"},
};
const std::set<Pair> v4_parameters{
    {"PixelFilter", "xradius"},   {"PixelFilter", "yradius"},     {"PixelFilter", "sigma"},
    {"LightSource", "power"},     {"LightSource", "illuminance"}, {"LightSource", "filename"},
    {"AreaLightSource", "power"},
};

// The first sign of each version.
struct Evidence {
    Place v3, v4;
    std::string v3_sign, v4_sign;

    void add(bool version3, const Place& place, const std::string& sign) {
        Place& first = version3 ? v3 : v4;
        if (first.file) return;
        first = place;
        (version3 ? v3_sign : v4_sign) = sign;
    }
};

void weigh_parameters(const Statement& statement, Evidence& evidence) {
    for (const Parameter& p : statement.parameters) {
        const Pair pair(statement.name, p.name);
        const std::string sign = "the parameter \"" + p.name + "\"";
        if (v3_parameters.count(pair)) evidence.add(true, p.place, sign);
        if (v4_parameters.count(pair)) evidence.add(false, p.place, sign);
        if (p.spelling == "color") evidence.add(true, p.place, "the type color");
        if (p.type == ParameterType::boolean)
            evidence.add(!p.bare_boolean, p.place,
                         p.bare_boolean ? "true or false without quotes" : "a quoted bool");
        const bool is_light =
            statement.name == "LightSource" || statement.name == "AreaLightSource";
        if (p.type == ParameterType::blackbody)
            evidence.add(p.numbers.size() == 2, p.place, "the form of a blackbody");
        if (is_light && p.name == "scale")
            evidence.add(p.type != ParameterType::number, p.place, "the type of a light's scale");
    }
}

void weigh_material(const std::string& type, const Place& place, Evidence& evidence) {
    const std::string sign = "the material \"" + type + "\"";
    if (v3_materials.count(type)) evidence.add(true, place, sign);
    if (v4_materials.count(type)) evidence.add(false, place, sign);
}

// Whether a file says what the material is; its type may then be any word.
bool names_a_model(const Statement& statement) {
    const auto& all = statement.parameters;
    return std::any_of(all.begin(), all.end(), [](const auto& p) { return p.name == "brdf"; });
}

void weigh(const Statement& statement, Evidence& evidence) {
    const std::string title = statement.title();
    if (v3_directives.count(statement.name)) evidence.add(true, statement.place, title);
    if (v4_directives.count(statement.name)) evidence.add(false, statement.place, title);
    if (!statement.strings.empty()) {
        const Word& kind = statement.strings[0];
        const Pair pair(statement.name, kind.text);
        if (v3_classes.count(pair)) evidence.add(true, kind.place, title);
        if (v4_classes.count(pair)) evidence.add(false, kind.place, title);
        if (statement.name == "Material" && !names_a_model(statement))
            weigh_material(kind.text, kind.place, evidence);
    }
    if (statement.name == "MakeNamedMaterial" && !names_a_model(statement))
        for (const Parameter& p : statement.parameters)
            if (p.name == "type" && p.strings.size() == 1)
                weigh_material(p.strings[0], p.values_place, evidence);
    weigh_parameters(statement, evidence);
}

}  // namespace

Dialect find_dialect(const SceneFiles& files) {
    Evidence evidence;
    for (const auto& file : files.in_reading_order())
        for (const Statement& statement : file->statements) weigh(statement, evidence);
    if (evidence.v3.file && evidence.v4.file)
        throw Error(ExitCode::scene,
                    "the scene is written for pbrt-v3 (" + evidence.v3_sign + ", " +
                        to_string(evidence.v3) + ") and for pbrt-v4 (" + evidence.v4_sign + ", " +
                        to_string(evidence.v4) + ")",
                    files.root().source->path, "say which with --dialect v3 or --dialect v4");
    return evidence.v3.file ? Dialect::v3 : Dialect::v4;
}

}  // namespace lobe
