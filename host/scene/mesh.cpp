// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh.h"

#include <cmath>

#include "scene/transform.h"

namespace lobe {

namespace {

glm::dvec3 winding_normal(const Mesh& mesh, const glm::uvec3& f) {
    const auto& p = mesh.positions;
    return glm::cross(p[f.y] - p[f.x], p[f.z] - p[f.x]);
}

}  // namespace

bool transform_mesh(Mesh& mesh, const glm::dmat4& m) {
    bool finite = true;
    for (glm::dvec3& p : mesh.positions) {
        p = transform_point(m, p);
        finite = finite && std::isfinite(p.x + p.y + p.z);
    }
    const glm::dmat3 normals = normal_matrix(m);
    for (glm::vec3& n : mesh.normals) {
        const glm::dvec3 moved = normals * glm::dvec3(n);
        const double length = glm::length(moved);
        n = length > 0 ? glm::vec3(moved / length) : glm::vec3(0);
    }
    return finite;
}

std::size_t mend_normals(Mesh& mesh) {
    std::size_t count = 0;
    for (const glm::vec3& n : mesh.normals) count += n == glm::vec3(0);
    if (count == 0) return 0;
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
    for (const glm::uvec3& f : mesh.triangles)
        for (int k = 0; k < 3; ++k) sums[f[k]] += winding_normal(mesh, f);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (mesh.normals[i] != glm::vec3(0)) continue;
        const double length = glm::length(sums[i]);
        mesh.normals[i] = length > 0 ? glm::vec3(sums[i] / length) : glm::vec3(0, 0, 1);
    }
    return count;
}

bool unify_winding(Mesh& mesh) {
    const auto side = [&](const glm::uvec3& f) {
        const glm::vec3 sum = mesh.normals[f.x] + mesh.normals[f.y] + mesh.normals[f.z];
        return glm::dot(winding_normal(mesh, f), glm::dvec3(sum));
    };
    std::size_t against = 0, along = 0;
    for (const glm::uvec3& f : mesh.triangles) {
        against += side(f) < 0;
        along += side(f) > 0;
    }
    const bool most_against = against > along;
    for (glm::uvec3& f : mesh.triangles)
        if (most_against ? side(f) > 0 : side(f) < 0) std::swap(f.y, f.z);
    return most_against;
}

std::size_t count_degenerate(const Mesh& mesh) {
    std::size_t count = 0;
    for (const glm::uvec3& f : mesh.triangles) count += winding_normal(mesh, f) == glm::dvec3(0);
    return count;
}

Shape moved(const Shape& shape, const glm::dmat4& m, bool& fits) {
    Shape copy = shape;
    if (auto* mesh = std::get_if<Mesh>(&copy.geometry)) {
        fits = transform_mesh(*mesh, m);
        // the normal moves as a normal does; the winding turns with the handedness
        copy.flipped = shape.flipped != swaps_handedness(m);
        return copy;
    }
    Sphere& sphere = std::get<Sphere>(copy.geometry);
    const auto scale = uniform_scale(m);
    fits = scale.has_value();
    sphere.centre = transform_point(m, sphere.centre);
    sphere.radius *= scale.value_or(1);
    return copy;
}

}  // namespace lobe
