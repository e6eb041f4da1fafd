// SPDX-License-Identifier: Apache-2.0
#include "build/placement.h"

#include <algorithm>
#include <cmath>

namespace lobe {
namespace {

template <typename Visit>
void for_each_point(const Scene& scene, Visit visit) {
    for (const Shape& shape : scene.shapes) {
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
            std::vector<bool> used(mesh->positions.size());  // stray vertices have no say
            for (const glm::uvec3& t : mesh->triangles) used[t.x] = used[t.y] = used[t.z] = true;
            for (std::size_t i = 0; i < used.size(); ++i)
                if (used[i]) visit(mesh->positions[i], 0.0);
        } else {
            const auto& sphere = std::get<Sphere>(shape.geometry);
            visit(sphere.centre, sphere.radius);
        }
    }
}

glm::dvec3 median_point(const Scene& scene) {
    glm::dvec3 median(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> coordinates;
        for_each_point(scene, [&](const glm::dvec3& p, double) { coordinates.push_back(p[axis]); });
        if (coordinates.empty()) break;
        const auto middle = coordinates.begin() + static_cast<long>(coordinates.size() / 2);
        std::nth_element(coordinates.begin(), middle, coordinates.end());
        median[axis] = *middle;
    }
    return median;
}

}  // namespace

Placement place_scene(const Scene& scene) {
    Placement placement;
    placement.centre = median_point(scene);
    double extent = 0;
    const auto reach = [&](const glm::dvec3& p, double radius) {
        for (int axis = 0; axis < 3; ++axis)
            extent = std::max(extent, std::abs(p[axis] - placement.centre[axis]) + radius);
    };
    for_each_point(scene, reach);
    reach(glm::dvec3(scene.camera.camera_to_world[3]), 0);
    if (extent > 0) {
        int exponent = 0;
        std::frexp(extent, &exponent);  // extent <= 2^exponent
        placement.scale = std::ldexp(1.0, -exponent);
    }
    return placement;
}

}  // namespace lobe
