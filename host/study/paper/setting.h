// SPDX-License-Identifier: Apache-2.0
// What the paper's experiment compares: one scene whose glossy surfaces wear one model after the
// other, at parameters made alike in one of three senses.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/brdf_table.h"
#include "scene/scene.h"

namespace lobe {

// A model's parameters as BRDF values: kd and ks in 1/sr.
struct LobeParameters {
    glm::dvec3 kd{0}, ks{0};
    double n = 0;
};

// What is alike between the rational model and another; kd always is.
enum class Footing {
    parameters,  // ks and n
    albedo,      // n, and the lobe's directional albedo at normal incidence, by the other's ks
    half_width,  // ks, which is the lobe's peak, and its half-width at half maximum, by the other's
                 // n: what differs is the tail
};
constexpr std::array<Footing, 3> footings = {Footing::parameters, Footing::albedo,
                                             Footing::half_width};
const char* to_text(Footing footing);  // "equal parameters"
const char* key_of(Footing footing);   // "parameters"

// How a lobe is measured: see matching.h.
struct LobeMeasure {
    // Directional albedo at normal incidence of the lobe with ks = 1, kd = 0, in sr.
    std::function<double(const std::string& model, double n)> albedo;
    // n of `model` for the half-width that the rational lobe has at n.
    std::function<double(const std::string& model, double n)> equal_width;
};

// A surface that wears the models, with what the rational one has there.
struct Wearer {
    std::uint32_t material;  // place in Scene::materials
    std::string type;        // as the scene file calls it
    LobeParameters base;
};

// The materials of these types. kd and ks are theirs, albedos made BRDF values; n is `n` if given,
// else the material's own, else 100. Throws Error (usage) where the scene has no such material,
// (scene) for one without a diffuse part or with an n that no lobe can be measured at.
std::vector<Wearer> find_wearers(const Scene& scene, const std::vector<BrdfTable>& models,
                                 const std::vector<std::string>& types, std::optional<double> n,
                                 const LobeMeasure& measure);

struct ModelSetting {
    std::string model;  // "rational", "phong", "modified_phong"
    Footing footing = Footing::parameters;
    bool listing = false;  // the rational model as the paper's listing computes it
    std::vector<LobeParameters> parameters;  // one a wearer

    std::string name() const;  // "phong, equal albedo"
};

// The distinct settings: rational (the same in every sense), Phong and modified Phong in each of
// the three, and last the listing.
std::vector<ModelSetting> paper_settings(const std::vector<Wearer>& wearers,
                                         const LobeMeasure& measure);

// The place among paper_settings() of a model (0 rational, 1 Phong, 2 modified Phong).
std::size_t setting_of(std::size_t model, Footing footing);
constexpr std::size_t listing_setting = 7;

// The scene with its wearers dressed so. `models` holds the tables of the three.
Scene dressed(Scene scene, const std::vector<Wearer>& wearers, const ModelSetting& setting,
              const std::vector<BrdfTable>& models);

}  // namespace lobe
