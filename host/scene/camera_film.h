// SPDX-License-Identifier: Apache-2.0
// The directives before WorldBegin: camera, film, filter, sampler, integrator.
#pragma once

#include "scene/context.h"
#include "scene/syntax.h"

namespace lobe {

// What a file that says nothing about them means in its dialect.
void set_defaults(Scene& scene);

void read_camera(const Statement& statement, const glm::dmat4& world_to_camera,
                 ReadContext& context);
void read_film(const Statement& statement, ReadContext& context);
void read_filter(const Statement& statement, ReadContext& context);
void read_sampler(const Statement& statement, ReadContext& context);
void read_integrator(const Statement& statement, ReadContext& context);

}  // namespace lobe
