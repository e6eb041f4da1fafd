// SPDX-License-Identifier: Apache-2.0
// What a scene needs of the kernel, each part with the scene object that asks for it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/brdf_table.h"
#include "build/integrator.h"
#include "scene/scene.h"

namespace lobe {

enum class Feature {
#define LOBE_FEATURE(name, meaning) name,
#include "shared/features.def"
#undef LOBE_FEATURE
    count
};

struct FeatureState {
    std::string name;     // "THIN_LENS"
    std::string meaning;  // "depth of field"
    bool in = false;
    std::string reason;  // what asked for it, or why it is left out
};

using FeatureSet = std::array<FeatureState, static_cast<std::size_t>(Feature::count)>;

// Whether a hierarchy over so many triangles, 54 bytes each, outgrows the caches of a CPU, so that
// memory is to be asked early. It gains 5 to 10 % at ten million and costs as much below a million.
bool outgrows_caches(std::size_t triangles);

// The features that the scene needs.
FeatureSet derive_features(const Scene& scene);

// All features, for a general kernel: the picture is the same to the bit.
FeatureSet all_features();

// Whether a feature is a hint to the device: it changes the time, never the picture.
constexpr bool is_hint(Feature feature) { return feature == Feature::FETCH_AHEAD; }

// Compiles a feature in that the scene may not need.
void force(FeatureSet& set, Feature feature);

// The names of the models that the scene's materials use, sorted.
std::vector<std::string> models_in_use(const Scene& scene);

// The text of lobe_scene.h, which tells the kernel what to leave out, which models to include and
// how many samples a work-item takes side by side: 1 or 8.
std::string scene_header(const FeatureSet& features, const std::vector<BrdfTable>& models,
                         const Integrator& integrator = {}, unsigned abreast = 1);

}  // namespace lobe
