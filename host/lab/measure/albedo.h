// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "lab/brdf_probe.h"
#include "lab/hemisphere.h"

namespace lobe {

struct AlbedoCase {
    std::uint32_t set;  // of the probe's parameters
    glm::dvec3 wo;
};

struct Albedo {
    glm::dvec3 value;   // part of the light that is reflected, by channel
    glm::dvec3 mirror;  // what of it goes into delta lobes
    double error;       // how far off the cubature may be
};

struct AlbedoEffort {
    std::size_t pilot = 2048, cells = 128;  // samples that shape the cells, and these
    CubatureOptions cubature;
};

// The directional albedo seen from wo, for each case: the integral of f cos theta over the
// hemisphere by adaptive cubature of the device's values, and the delta lobes' reflectance.
std::vector<Albedo> directional_albedos(const BrdfProbe& probe,
                                        const std::vector<AlbedoCase>& cases,
                                        const AlbedoEffort& effort = {});

}  // namespace lobe
