// SPDX-License-Identifier: Apache-2.0
// What every part of the reader needs to know.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scene/read.h"
#include "scene/source.h"

namespace lobe {

// A texture by name. Only constant ones have a value; the others are refused when they are used.
struct Texture {
    std::string kind;  // "constant"
    glm::dvec3 value{1.0};
    bool is_float = false;
    Place place;
};

// The names that directives give to materials (indices into Scene::materials) and textures.
struct Names {
    std::map<std::string, std::uint32_t> materials;
    std::map<std::string, Texture> textures;
};

struct ReadContext {
    const std::vector<BrdfTable>& models;
    const ReadOptions& options;
    Scene& scene;
    std::shared_ptr<Names> names;  // those in force
    std::string folder;            // of the scene file

    bool v4() const { return scene.dialect == Dialect::v4; }

    void warn(const Place& place, const std::string& text) const {
        scene.warnings.push_back(to_string(place) + ": " + text);
    }

    // A fault that `lenient` turns into a warning.
    void fault(const Place& place, const std::string& what, const std::string& hint) const {
        if (!options.lenient) fail(place, what, hint);
        warn(place, what);
    }
};

// The path of a file that the file at `place` names: relative to the file that names it or, where
// there is none, to the scene file's folder (as pbrt does).
std::string resolve_path(const ReadContext& context, const std::string& name, const Place& place);

}  // namespace lobe
