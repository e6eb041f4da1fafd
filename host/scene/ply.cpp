// SPDX-License-Identifier: Apache-2.0
#include "scene/ply.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "scene/ply_values.h"
#include "scene/source.h"

namespace lobe {

namespace {

// Where a vertex row holds what; -1 where it does not.
struct VertexColumns {
    std::array<int, 3> position, normal;
    std::array<int, 2> uv;
    bool has_normals() const { return normal[0] >= 0 && normal[1] >= 0 && normal[2] >= 0; }
    bool has_uvs() const { return uv[0] >= 0 && uv[1] >= 0; }
};

VertexColumns find_columns(const PlyElement& vertex) {
    return {{vertex.find({"x"}), vertex.find({"y"}), vertex.find({"z"})},
            {vertex.find({"nx"}), vertex.find({"ny"}), vertex.find({"nz"})},
            {vertex.find({"u", "s", "texture_u", "texture_s"}),
             vertex.find({"v", "t", "texture_v", "texture_t"})}};
}

bool is_taken(const std::string& property) {
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "u", "v", "s", "t", "texture_u",
                             "texture_v", "texture_s", "texture_t"})
        if (property == name) return true;
    return false;
}

void skip_list(PlyValues& values, const PlyProperty& list) {
    for (std::size_t i = values.next_length(list); i > 0; --i) values.next(list.type);
}

// A vertex's value; all but positions are kept as floats.
double finite(PlyValues& values, const PlyProperty& property) {
    const double value = values.next(property.type);
    if (!std::isfinite(value)) values.fail("a vertex value is not finite");
    const bool position = property.name == "x" || property.name == "y" || property.name == "z";
    if (!position && std::fabs(value) > std::numeric_limits<float>::max())
        values.fail("the vertex value " + show(value) + " is too large");
    return value;
}

void read_vertices(PlyValues& values, const PlyElement& element, Mesh& mesh) {
    const VertexColumns columns = find_columns(element);
    for (const int column : columns.position)
        if (column < 0) values.fail("element 'vertex' lacks x, y or z");
    for (const PlyProperty& property : element.properties)
        if (property.is_list && is_taken(property.name))
            values.fail("property '" + property.name + "' of 'vertex' is a list");
    std::vector<double> row(element.properties.size());
    mesh.positions.reserve(element.count);
    if (columns.has_normals()) mesh.normals.reserve(element.count);
    if (columns.has_uvs()) mesh.uvs.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
        for (std::size_t p = 0; p < row.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (property.is_list) {
                skip_list(values, property);
            } else {
                row[p] = finite(values, property);
            }
        }
        const auto at = [&](int column) { return row[static_cast<std::size_t>(column)]; };
        const auto& [x, y, z] = columns.position;
        mesh.positions.emplace_back(at(x), at(y), at(z));
        const auto& n = columns.normal;
        if (columns.has_normals()) mesh.normals.emplace_back(at(n[0]), at(n[1]), at(n[2]));
        if (columns.has_uvs()) mesh.uvs.emplace_back(at(columns.uv[0]), at(columns.uv[1]));
    }
}

// One face's corners as a fan around the first.
void read_polygon(PlyValues& values, const PlyProperty& list, std::uint64_t vertices, Mesh& mesh) {
    const std::size_t corners = values.next_length(list);
    if (corners < 3) values.fail("a face of " + std::to_string(corners) + " corners");
    std::uint32_t first = 0, previous = 0;
    for (std::size_t i = 0; i < corners; ++i) {
        const double index = values.next(list.type);
        if (!(index >= 0 && index < static_cast<double>(vertices)) || index != std::floor(index))
            values.fail("vertex index " + show(index) + " is not one of the " +
                        std::to_string(vertices) + " vertices");
        const auto corner = static_cast<std::uint32_t>(index);
        if (i == 0) first = corner;
        if (i >= 2) mesh.triangles.emplace_back(first, previous, corner);
        previous = corner;
    }
}

void read_faces(PlyValues& values, const PlyElement& element, std::uint64_t vertices, Mesh& mesh) {
    const int corners = element.find({"vertex_indices", "vertex_index"});
    if (corners < 0 || !element.properties[static_cast<std::size_t>(corners)].is_list)
        values.fail("element 'face' lacks the list vertex_indices");
    mesh.triangles.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (static_cast<int>(p) == corners) {
                read_polygon(values, property, vertices, mesh);
            } else if (property.is_list) {
                skip_list(values, property);
            } else {
                values.next(property.type);
            }
        }
    }
}

void skip_rows(PlyValues& values, const PlyElement& element) {
    for (std::uint64_t i = 0; i < element.count; ++i)
        for (const PlyProperty& property : element.properties)
            if (property.is_list) {
                skip_list(values, property);
            } else {
                values.next(property.type);
            }
}

}  // namespace

Mesh parse_ply(const std::string& path, const std::string& bytes) {
    if (bytes.compare(0, 2, "\x1f\x8b") == 0)
        throw Error(ExitCode::scene, "compressed PLY files are not supported", path,
                    "unpack it with gunzip");
    const PlyHeader header = parse_ply_header(path, bytes);
    PlyValues values(path, bytes, header);
    Mesh mesh;
    std::uint64_t vertices = 0;
    bool has_vertices = false, has_faces = false;
    for (const PlyElement& element : header.elements)
        if (element.name == "vertex") vertices = element.count;
    for (const PlyElement& element : header.elements) {
        values.check_room(element);
        if (element.name == "vertex" && !has_vertices) {
            read_vertices(values, element, mesh);
            has_vertices = true;
        } else if (element.name == "face" && !has_faces) {
            read_faces(values, element, vertices, mesh);
            has_faces = true;
        } else if (element.name == "vertex" || element.name == "face") {
            values.fail("element '" + element.name + "' comes twice");
        } else {
            skip_rows(values, element);
        }
    }
    if (!has_vertices || !has_faces)
        throw Error(ExitCode::scene, "the file lacks vertices or faces", path);
    return mesh;
}

}  // namespace lobe
