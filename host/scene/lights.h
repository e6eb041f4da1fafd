// SPDX-License-Identifier: Apache-2.0
// Light sources of scene files.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "scene/context.h"
#include "scene/syntax.h"

namespace lobe {

// What an AreaLightSource directive gives to the shapes after it.
struct AreaLight {
    glm::dvec3 radiance;
    bool two_sided = false;
    std::optional<double> power;  // of each triangle or sphere, in place of the radiance's scale
    Place place;
};

AreaLight read_area_light(const Statement& statement, const ReadContext& context);

// The emission of a shape under an area light.
Emission emission_of(const AreaLight& light, const Shape& shape);

// Adds the light of a LightSource directive to the scene.
void read_light(const Statement& statement, const glm::dmat4& light_to_world, ReadContext& context);

}  // namespace lobe
