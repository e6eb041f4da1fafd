// SPDX-License-Identifier: Apache-2.0
#include "build/features.h"

#include <algorithm>
#include <set>

namespace lobe {
namespace {

FeatureSet named_features() {
    FeatureSet set;
    std::size_t i = 0;
#define LOBE_FEATURE(id, text) \
    set[i].name = #id;         \
    set[i++].meaning = text;
#include "shared/features.def"
#undef LOBE_FEATURE
    return set;
}

class Derivation {
  public:
    // The first object that asks is the reason given.
    void need(Feature feature, const std::string& reason) {
        FeatureState& state = set_[static_cast<std::size_t>(feature)];
        if (!state.in) state.reason = reason;
        state.in = true;
    }
    void spare(Feature feature, const std::string& reason) {
        FeatureState& state = set_[static_cast<std::size_t>(feature)];
        if (!state.in) state.reason = reason;
    }
    FeatureSet set() const { return set_; }

  private:
    FeatureSet set_ = named_features();
};

std::size_t emitting_primitives(const Shape& shape) {
    if (!shape.emission) return 0;
    const auto* mesh = std::get_if<Mesh>(&shape.geometry);
    return mesh ? mesh->triangles.size() : 1;
}

}  // namespace

bool outgrows_caches(std::size_t triangles) { return triangles > 700000; }

FeatureSet derive_features(const Scene& scene) {
    Derivation d;
    std::size_t triangles = 0;
    for (const Shape& shape : scene.shapes)
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry))
            triangles += mesh->triangles.size();
    if (outgrows_caches(triangles))
        d.need(Feature::FETCH_AHEAD, std::to_string(triangles) + " triangles");
    for (const Shape& shape : scene.shapes) {
        const bool sphere = std::holds_alternative<Sphere>(shape.geometry);
        d.need(sphere ? Feature::SPHERES : Feature::TRIANGLES, "shape at " + shape.where);
        if (shape.emission)
            d.need(sphere ? Feature::SPHERE_LIGHTS : Feature::TRIANGLE_LIGHTS,
                   "emitting shape at " + shape.where);
    }
    if (!scene.point_lights.empty()) d.need(Feature::POINT_LIGHTS, "a point light");
    if (!scene.distant_lights.empty()) d.need(Feature::DISTANT_LIGHTS, "a distant light");
    std::size_t lights = scene.point_lights.size() + scene.distant_lights.size();
    for (const Shape& shape : scene.shapes) lights += emitting_primitives(shape);
    if (lights > 1) d.need(Feature::MANY_LIGHTS, std::to_string(lights) + " lights");
    if (scene.camera.lens_radius > 0) d.need(Feature::THIN_LENS, "the camera's lens radius");

    d.spare(Feature::SPHERES, "no shape is a sphere");
    d.spare(Feature::FETCH_AHEAD, "caches hold the shapes, or most of them");
    d.spare(Feature::TRIANGLES, "no shape has triangles");
    d.spare(Feature::SPHERE_LIGHTS, "no sphere emits");
    d.spare(Feature::TRIANGLE_LIGHTS, "no triangle emits");
    d.spare(Feature::POINT_LIGHTS, "no point light");
    d.spare(Feature::DISTANT_LIGHTS, "no distant light");
    d.spare(Feature::MANY_LIGHTS, lights ? "there is but one light" : "no light to choose");
    d.spare(Feature::THIN_LENS, "the camera is a pinhole");
    return d.set();
}

FeatureSet all_features() {
    FeatureSet set = named_features();
    for (FeatureState& state : set) {
        state.in = true;
        state.reason = "asked for";
    }
    return set;
}

void force(FeatureSet& set, Feature feature) {
    FeatureState& state = set[static_cast<std::size_t>(feature)];
    if (!state.in) state.reason = "forced";
    state.in = true;
}

std::vector<std::string> models_in_use(const Scene& scene) {
    std::set<std::string> models;
    for (const Material& material : scene.materials) models.insert(material.brdf);
    return {models.begin(), models.end()};
}

std::string scene_header(const FeatureSet& features, const std::vector<BrdfTable>& models,
                         const Integrator& integrator, unsigned abreast) {
    std::string text = "// What this scene needs of the kernel, and no more.\n";
    for (const FeatureState& state : features)
        text += "#define LOBE_HAS_" + state.name + (state.in ? " 1\n" : " 0\n");
    const auto choose = [&](const char* name, bool on) {
        text += std::string("#define LOBE_") + name + (on ? " 1\n" : " 0\n");
    };
    choose("INDEPENDENT_NUMBERS", integrator.sampler == Integrator::Sampler::independent);
    choose("SENDS_LIGHT", integrator.strategy != Integrator::Strategy::brdf);
    choose("SEES_LIGHT", integrator.strategy != Integrator::Strategy::light);
    choose("BALANCE_HEURISTIC", integrator.heuristic == Integrator::Heuristic::balance);
    choose("COSINE_DIRECTIONS", integrator.directions == Integrator::Directions::cosine);
    text += "#define LOBE_ABREAST " + std::to_string(abreast) + "\n";
    text += "#define LOBE_BRDFS(X)";
    for (const BrdfTable& model : models) text += " X(" + model.name + ")";
    text += "\n";
    for (const BrdfTable& model : models) text += "#include \"" + model.file + "\"\n";
    return text;
}

}  // namespace lobe
