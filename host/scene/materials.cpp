// SPDX-License-Identifier: Apache-2.0
// pbrt's materials. Formulas and defaults: the file formats and source of pbrt-v3 and pbrt-v4.
#include "scene/materials.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "scene/metals.h"

namespace lobe {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double inf = std::numeric_limits<double>::infinity();

glm::dvec3 reflectance(Parameters& p, std::initializer_list<const char*> names, double standard,
                       const ReadContext& context) {
    const glm::dvec3 value = p.colour(names, glm::dvec3(standard));
    p.check_range(value, 0, inf);
    p.check_float(value);
    if (std::max({value.x, value.y, value.z}) > 1)
        context.warn(p.last_place(), "a reflectance above one makes energy");
    return value;
}

// A fit of GGX's alpha to pbrt-v3's roughness, or the square root of pbrt-v4's.
double alpha_of(double roughness, bool remap, bool v4) {
    if (!remap) return v4 ? roughness : std::max(roughness, 1e-3);
    if (v4) return std::sqrt(roughness);
    const double x = std::log(std::max(roughness, 1e-3));
    const double alpha =
        1.62142 + x * (0.819955 + x * (0.1734 + x * (0.0171201 + x * 0.000640711)));
    return std::max(alpha, 1e-3);
}

MaterialRows matte(Parameters& p, const ReadContext& context) {
    const double sigma = p.number({"sigma"}, 0);
    p.check_range(sigma, 0, 90);
    MaterialRows rows(model_table(context, sigma > 0 ? "oren_nayar" : "lambert"));
    rows.set("kd", reflectance(p, {"Kd", "reflectance"}, 0.5, context) / pi);
    if (sigma > 0) rows.set("sigma", sigma);
    p.refuse({"bumpmap", "displacement", "normalmap"});
    return rows;
}

MaterialRows plastic(Parameters& p, const ReadContext& context) {
    MaterialRows rows(model_table(context, "plastic"));
    rows.set("kd", reflectance(p, {"Kd"}, 0.25, context) / pi);
    rows.set("ks", reflectance(p, {"Ks"}, 0.25, context));
    const bool remap = p.flag({"remaproughness"}, true);
    const double roughness = p.number({"roughness"}, 0.1);
    p.check_range(roughness, 0, 10);
    rows.set("alpha", alpha_of(roughness, remap, false));
    // pbrt-v3 passes the two indices in the order (1.5, 1), unlike its book, and its author keeps
    // it so for the sake of existing scenes: its plastic reflects as seen from inside.
    rows.set("eta", 1 / 1.5);
    p.refuse({"bumpmap", "displacement", "normalmap"});
    return rows;
}

// eta and k of a conductor, from themselves or from the reflectance at normal incidence.
std::pair<glm::dvec3, glm::dvec3> optical_constants(Parameters& p) {
    if (const Parameter* given = p.find({"reflectance"})) {
        const glm::dvec3 value = p.colour_of(*given);
        p.check_range(value, 0, 1);
        if (p.find({"eta"}) || p.find({"k"}))
            fail(p.last_place(), "a conductor has either reflectance or eta and k");
        const glm::dvec3 r = glm::min(value, glm::dvec3(0.9999));
        return {glm::dvec3(1), 2.0 * glm::sqrt(r) / glm::sqrt(1.0 - r)};
    }
    const Metal& copper = metals[3];
    const glm::dvec3 eta = p.colour({"eta"}, copper.eta);
    p.check_range(eta, 0, 10000);
    const glm::dvec3 k = p.colour({"k"}, copper.k);
    p.check_range(k, 0, 10000);
    return {eta, k};
}

MaterialRows conductor_of(Parameters& p, const ReadContext& context, bool v4) {
    MaterialRows rows(model_table(context, "conductor"));
    const auto [eta, k] = optical_constants(p);
    rows.set("eta", eta);
    rows.set("k", k);
    const bool remap = p.flag({"remaproughness"}, true);
    const double roughness = p.number({"roughness"}, v4 ? 0 : 0.01);
    p.check_range(roughness, 0, 10);
    for (const auto& [parameter, row] :
         {std::pair("uroughness", "alpha_x"), {"vroughness", "alpha_y"}}) {
        const double value = p.number({parameter}, roughness);
        p.check_range(value, 0, 10);
        rows.set(row, alpha_of(value, remap, v4));
    }
    p.refuse({"bumpmap", "displacement", "normalmap"});
    return rows;
}

MaterialRows conductor(Parameters& p, const ReadContext& context) {
    return conductor_of(p, context, true);
}

MaterialRows metal(Parameters& p, const ReadContext& context) {
    return conductor_of(p, context, false);
}

MaterialRows mirror(Parameters& p, const ReadContext& context) {
    MaterialRows rows(model_table(context, "mirror"));
    rows.set("kr", reflectance(p, {"Kr"}, 0.9, context));
    p.refuse({"bumpmap"});
    return rows;
}

using Reader = MaterialRows (*)(Parameters&, const ReadContext&);
const std::map<std::string, Reader> readers{
    {"matte", matte},         {"diffuse", matte}, {"plastic", plastic},
    {"conductor", conductor}, {"metal", metal},   {"mirror", mirror},
};

const std::vector<std::string> not_yet{
    "",
    "none",
    "interface",
    "coatedconductor",
    "coateddiffuse",
    "dielectric",
    "fourier",
    "glass",
    "hair",
    "kdsubsurface",
    "mix",
    "substrate",
    "subsurface",
    "diffusetransmission",
    "translucent",
    "uber",
    "thindielectric",
};

[[noreturn]] void refuse_type(const std::string& type, const Place& place,
                              const ReadContext& context) {
    std::vector<std::string> names;
    for (const auto& row : readers) names.push_back(row.first);
    for (const BrdfTable& table : context.models)
        if (!readers.count(table.name)) names.push_back(table.name);
    fail_class(place, "material", type, names, not_yet);
}

}  // namespace

bool is_pbrt_material(const std::string& name) { return readers.count(name) > 0; }

Material read_material(const Statement& statement, const std::string& type, const Place& type_place,
                       const ReadContext& context) {
    Parameters parameters(statement, context, "material \"" + type + "\"");
    parameters.ignore({"type"});
    Material material{"", {}, type, to_string(statement.place)};
    const std::string file = parameters.text({"brdf"}, "");
    const auto reader = readers.find(type);
    if (const Parameter* given = parameters.find({"brdf"})) {
        const BrdfTable& table = model_of_file(file, given->values_place, context);
        material.rows = read_model(parameters, table, context).rows();
        material.brdf = table.name;
    } else if (reader != readers.end()) {
        const MaterialRows rows = reader->second(parameters, context);
        material.rows = rows.rows();
        material.brdf = rows.model();
    } else if (const BrdfTable* table = find_model(context, type)) {
        material.rows = read_model(parameters, *table, context).rows();
        material.brdf = table->name;
    } else {
        refuse_type(type, type_place, context);
    }
    parameters.finish();
    replace_model(material, context, statement.place);
    return material;
}

Material standard_material(const ReadContext& context) {
    MaterialRows rows(model_table(context, "lambert"));
    rows.set("kd", glm::dvec3(0.5 / pi));
    Material material{"lambert", rows.rows(), context.v4() ? "diffuse" : "matte",
                      context.scene.path};
    replace_model(material, context, {});
    return material;
}

}  // namespace lobe
