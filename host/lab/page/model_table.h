// SPDX-License-Identifier: Apache-2.0
// What `lobe brdf table` tells of a model: values, albedo and the lobe, from several angles.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lab/measure/albedo.h"
#include "lab/measure/plane.h"
#include "lab/settings.h"

namespace lobe {

struct ViewRow {
    double degrees;  // of the viewer
    Albedo albedo;
    PlaneLobe lobe;
    std::vector<glm::dvec3> f;  // 1/sr, for each of ModelTable::light
};

struct ModelTable {
    Subject subject;
    BrdfClaims claims;
    std::vector<double> light;  // degrees in the plane of incidence, rising
    std::vector<ViewRow> views;
};

// Measures a model seen from these angles (degrees, at most 90) at an azimuth; light comes from the
// same angles on both sides. The probe keeps the subject's parameters.
ModelTable measure_model(BrdfProbe& probe, const Subject& subject,
                         const std::vector<double>& degrees, double azimuth = 0);

// For people; the JSON holds all channels and keys with units.
std::string to_text(const ModelTable& table);
nlohmann::ordered_json to_json(const ModelTable& table);

}  // namespace lobe
