// SPDX-License-Identifier: Apache-2.0
#include "study/paper/setting.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <set>

#include "base/error.h"

namespace lobe {
namespace {

constexpr double usual_n = 100;

const BrdfTable& table_of(const std::vector<BrdfTable>& models, const std::string& name) {
    for (const BrdfTable& table : models)
        if (table.name == name) return table;
    throw Error(ExitCode::scene,
                "the model '" + name + "' is missing from the kernels' brdf folder");
}

// A parameter of a material by name, or null.
const std::array<float, 4>* row_of(const Material& material, const BrdfTable& table,
                                   const char* name) {
    const int place = table.find(name);
    return place < 0 ? nullptr : &material.rows[static_cast<std::size_t>(place)];
}

glm::dvec3 colour(const std::array<float, 4>& row) { return {row[0], row[1], row[2]}; }

LobeParameters base_of(const Material& material, const BrdfTable& table, std::optional<double> n,
                       const LobeMeasure& measure) {
    const auto* const kd = row_of(material, table, "kd");
    if (!kd)
        throw Error(ExitCode::scene,
                    "material \"" + material.type +
                        "\" has no diffuse part: the models cannot "
                        "take its place",
                    material.where);
    const auto* const ks = row_of(material, table, "ks");
    const auto* const own_n = row_of(material, table, "n");
    LobeParameters base{colour(*kd), ks ? colour(*ks) : glm::dvec3(0),
                        own_n ? (*own_n)[0] : n.value_or(usual_n)};
    const auto* const normalize = row_of(material, table, "normalize");
    if (normalize && (*normalize)[0] != 0) {
        base.kd /= glm::pi<double>();
        if (!std::isinf(base.n)) base.ks /= measure.albedo(table.name, base.n);
    }
    base.n = n.value_or(base.n);
    if (!(base.n > 0 && base.n <= 1e12))
        throw Error(ExitCode::scene,
                    "n = " + std::to_string(base.n) + " has no lobe whose width can be matched",
                    material.where, "give a finite one above zero with --n");
    return base;
}

std::string types_of(const Scene& scene) {
    std::set<std::string> types;
    for (const Material& material : scene.materials) types.insert(material.type);
    std::string all;
    for (const std::string& type : types) all += (all.empty() ? "" : ", ") + type;
    return all;
}

std::string joined(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : " or ") + word;
    return all;
}

// Another model's parameters for the rational one's.
LobeParameters matched(const std::string& model, Footing footing, const LobeParameters& rational,
                       const LobeMeasure& measure) {
    LobeParameters p = rational;
    if (footing == Footing::albedo)
        p.ks *= measure.albedo("rational", p.n) / measure.albedo(model, p.n);
    if (footing == Footing::half_width) p.n = measure.equal_width(model, p.n);
    return p;
}

}  // namespace

const char* to_text(Footing footing) {
    switch (footing) {
        case Footing::parameters:
            return "equal parameters";
        case Footing::albedo:
            return "equal albedo";
        case Footing::half_width:
            break;
    }
    return "equal half-width";
}

const char* key_of(Footing footing) {
    switch (footing) {
        case Footing::parameters:
            return "parameters";
        case Footing::albedo:
            return "albedo";
        case Footing::half_width:
            break;
    }
    return "half_width";
}

std::string ModelSetting::name() const {
    if (listing) return model + ", listing";
    return model == "rational" ? model : model + ", " + to_text(footing);
}

std::vector<Wearer> find_wearers(const Scene& scene, const std::vector<BrdfTable>& models,
                                 const std::vector<std::string>& types, std::optional<double> n,
                                 const LobeMeasure& measure) {
    std::vector<Wearer> wearers;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        if (std::find(types.begin(), types.end(), material.type) == types.end()) continue;
        wearers.push_back(
            {i, material.type, base_of(material, table_of(models, material.brdf), n, measure)});
    }
    if (wearers.empty())
        throw Error(
            ExitCode::usage, "no material of the scene is " + joined(types), scene.path,
            "--replace TYPE says which the models take the place of; there are " + types_of(scene));
    return wearers;
}

std::vector<ModelSetting> paper_settings(const std::vector<Wearer>& wearers,
                                         const LobeMeasure& measure) {
    ModelSetting rational{"rational", Footing::parameters, false, {}};
    for (const Wearer& wearer : wearers) rational.parameters.push_back(wearer.base);
    std::vector<ModelSetting> settings = {rational};
    for (const Footing footing : footings) {
        for (const char* model : {"phong", "modified_phong"}) {
            ModelSetting setting{model, footing, false, {}};
            for (const Wearer& wearer : wearers)
                setting.parameters.push_back(matched(model, footing, wearer.base, measure));
            settings.push_back(setting);
        }
    }
    rational.listing = true;
    settings.push_back(rational);
    return settings;
}

std::size_t setting_of(std::size_t model, Footing footing) {
    return model == 0 ? 0 : 2 * static_cast<std::size_t>(footing) + model;
}

Scene dressed(Scene scene, const std::vector<Wearer>& wearers, const ModelSetting& setting,
              const std::vector<BrdfTable>& models) {
    const BrdfTable& table = table_of(models, setting.model);
    const auto set = [&](Material& material, const char* name, const glm::vec3& value) {
        const int place = table.find(name);
        if (place < 0)
            throw Error(ExitCode::scene,
                        "model '" + table.name + "' has no parameter '" + name + "' in its table",
                        table.file);
        material.rows[static_cast<std::size_t>(place)] = {value.x, value.y, value.z, 0};
    };
    for (std::size_t i = 0; i < wearers.size(); ++i) {
        Material& material = scene.materials[wearers[i].material];
        material.brdf = table.name;
        material.rows = table.default_rows();
        const LobeParameters& p = setting.parameters[i];
        set(material, "kd", p.kd);
        set(material, "ks", p.ks);
        set(material, "n", glm::vec3(p.n, 0, 0));
        set(material, "normalize", glm::vec3(0));
        if (setting.listing) set(material, "lobe", glm::vec3(2, 0, 0));
    }
    return scene;
}

}  // namespace lobe
