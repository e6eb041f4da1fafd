// SPDX-License-Identifier: Apache-2.0
// trianglemesh and loopsubdiv: meshes whose vertices stand in the scene file.
#include <cmath>

#include "scene/loop_subdivision.h"
#include "scene/shapes.h"

namespace lobe {

namespace {

const Parameter& required(Parameters& p, const char* name,
                          std::initializer_list<ParameterType> types) {
    const Parameter* parameter = p.list({name}, types);
    if (!parameter) fail(p.place(), p.title() + " lacks its parameter \"" + name + "\"");
    return *parameter;
}

std::vector<glm::dvec3> positions_of(const Parameter& parameter) {
    std::vector<glm::dvec3> positions;
    positions.reserve(parameter.numbers.size() / 3);
    for (std::size_t i = 0; i + 2 < parameter.numbers.size(); i += 3)
        positions.emplace_back(parameter.numbers[i], parameter.numbers[i + 1],
                               parameter.numbers[i + 2]);
    return positions;
}

std::vector<glm::uvec3> triangles_of(const Parameter& parameter, std::size_t vertices) {
    const std::vector<double>& indices = parameter.numbers;
    if (indices.size() % 3 != 0)
        fail(parameter.place, "\"" + parameter.name + "\" wants three indices a triangle, has " +
                                  std::to_string(indices.size()) + " in all");
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (!(indices[i] >= 0 && indices[i] < static_cast<double>(vertices)))
            fail(place_of_value(parameter, i), "vertex index " + show(indices[i]) +
                                                   " is not one of the " +
                                                   std::to_string(vertices) + " vertices");
    std::vector<glm::uvec3> triangles;
    triangles.reserve(indices.size() / 3);
    for (std::size_t i = 0; i < indices.size(); i += 3)
        triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    return triangles;
}

// A list with `components` numbers a vertex.
const Parameter* per_vertex(Parameters& p, Parameters::Names names,
                            std::initializer_list<ParameterType> types, std::size_t components,
                            std::size_t vertices) {
    const Parameter* parameter = p.list(names, types);
    if (parameter && parameter->numbers.size() != components * vertices)
        fail(parameter->place, "\"" + parameter->name + "\" wants " +
                                   std::to_string(components * vertices) + " numbers for " +
                                   std::to_string(vertices) + " vertices, has " +
                                   std::to_string(parameter->numbers.size()));
    return parameter;
}

}  // namespace

Mesh read_triangle_mesh(Parameters& p) {
    using Type = ParameterType;
    Mesh mesh;
    mesh.positions = positions_of(required(p, "P", {Type::point3, Type::vector3}));
    const std::size_t vertices = mesh.positions.size();
    if (vertices == 3 && !p.find({"indices"})) {
        mesh.triangles = {glm::uvec3(0, 1, 2)};
    } else {
        mesh.triangles = triangles_of(required(p, "indices", {Type::integer}), vertices);
    }
    if (const auto* n = per_vertex(p, {"N"}, {Type::normal, Type::vector3}, 3, vertices))
        for (const glm::dvec3& normal : positions_of(*n))
            mesh.normals.emplace_back(glm::length(normal) > 0 ? glm::normalize(normal) : normal);
    if (const auto* uv =
            per_vertex(p, {"uv", "st"}, {Type::point2, Type::number, Type::vector2}, 2, vertices))
        for (std::size_t i = 0; i < vertices; ++i) {
            const glm::dvec2 pair(uv->numbers[2 * i], uv->numbers[2 * i + 1]);
            p.check_float(glm::dvec3(pair, 0));
            mesh.uvs.emplace_back(pair);
        }
    p.ignore({"S", "faceIndices", "discarddegenerateUVs"});
    return mesh;
}

Mesh read_loop_mesh(Parameters& p) {
    using Type = ParameterType;
    const Parameter& indices = required(p, "indices", {Type::integer});
    SubdivisionMesh mesh;
    mesh.positions = positions_of(required(p, "P", {Type::point3, Type::vector3}));
    mesh.triangles = triangles_of(indices, mesh.positions.size());
    const int levels = p.integer({"levels", "nlevels"}, 3);
    p.check_range(levels, 0, 12);
    if (static_cast<double>(mesh.triangles.size()) * std::pow(4.0, levels) > (1 << 25))
        fail(p.last_place(), std::to_string(levels) + " levels of " +
                                 std::to_string(mesh.triangles.size()) +
                                 " triangles are too many (more than 2^25)");
    const std::string scheme = p.text({"scheme"}, "loop");
    if (scheme != "loop") fail(p.last_place(), "unknown subdivision scheme \"" + scheme + "\"");
    const std::string fault = loop_subdivide(mesh, levels);
    if (!fault.empty()) fail(indices.place, "loopsubdiv wants a manifold mesh: " + fault);
    Mesh out;
    out.positions = std::move(mesh.positions);
    out.triangles = std::move(mesh.triangles);
    out.normals.reserve(mesh.normals.size());
    for (const glm::dvec3& normal : mesh.normals) out.normals.emplace_back(normal);
    return out;
}

}  // namespace lobe
