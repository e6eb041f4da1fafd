// SPDX-License-Identifier: Apache-2.0
// Rules: C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987, with the weights of
// Warren (3/16 for valence 3, else 3/(8n)); boundary and limit masks: Hoppe et al., "Piecewise
// Smooth Surface Reconstruction", 1994; as in Pharr, Jakob and Humphreys, section 3.8 (3rd ed.).
// Boundaries end with pbrt's mask 1/5 3/5 1/5 everywhere (a regular one would have 1/6 2/3 1/6), so
// that silhouettes agree; normals are those of the limit surface, from the control points.
#include "scene/loop_subdivision.h"

#include <cmath>

#include "scene/mesh_edges.h"

namespace lobe {

namespace {

constexpr double pi = 3.14159265358979323846;

double ring_weight(std::uint32_t valence) {
    return valence == 3 ? 3.0 / 16 : 3.0 / (8.0 * valence);
}

// Every vertex moved by its ring (weight_of(valence) a neighbour) or, on the boundary, by its two
// boundary neighbours (boundary_weight each).
template <typename Weight>
std::vector<glm::dvec3> smoothed(const std::vector<glm::dvec3>& old, const MeshEdges& mesh,
                                 Weight weight_of, double boundary_weight) {
    std::vector<glm::dvec3> sums(old.size(), glm::dvec3(0));
    for (const MeshEdges::Edge& edge : mesh.edges) {
        if (edge.boundary() || !mesh.boundary[edge.from]) sums[edge.from] += old[edge.to];
        if (edge.boundary() || !mesh.boundary[edge.to]) sums[edge.to] += old[edge.from];
    }
    for (std::size_t v = 0; v < old.size(); ++v) {
        const double neighbours = mesh.boundary[v] ? 2 : mesh.valence[v];
        const double weight = mesh.boundary[v] ? boundary_weight : weight_of(mesh.valence[v]);
        sums[v] = (1 - neighbours * weight) * old[v] + weight * sums[v];
    }
    return sums;
}

glm::dvec3 edge_point(const SubdivisionMesh& mesh, const MeshEdges::Edge& edge) {
    const auto& p = mesh.positions;
    const glm::dvec3 ends = p[edge.from] + p[edge.to];
    if (edge.boundary()) return 0.5 * ends;
    const auto opposite = [&](std::uint32_t half) {
        return p[mesh.triangles[half / 3][static_cast<int>((half + 2) % 3)]];
    };
    return 0.375 * ends + 0.125 * (opposite(edge.first) + opposite(edge.second));
}

void subdivide_once(SubdivisionMesh& mesh, const MeshEdges& edges) {
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
    std::vector<glm::dvec3> positions = smoothed(mesh.positions, edges, ring_weight, 0.125);
    positions.reserve(vertices + edges.edges.size());
    for (const MeshEdges::Edge& edge : edges.edges) positions.push_back(edge_point(mesh, edge));
    std::vector<glm::uvec3> triangles;
    triangles.reserve(4 * mesh.triangles.size());
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
        const glm::uvec3 v = mesh.triangles[f];
        const glm::uvec3 e(vertices + edges.edge_of[3 * f], vertices + edges.edge_of[3 * f + 1],
                           vertices + edges.edge_of[3 * f + 2]);
        triangles.emplace_back(v.x, e.x, e.z);
        triangles.emplace_back(e.x, v.y, e.y);
        triangles.emplace_back(e.z, e.y, v.z);
        triangles.push_back(e);
    }
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(triangles);
}

// Tangents of the limit surface at an inner vertex: the first harmonic of its ring.
glm::dvec3 inner_normal(const std::vector<glm::dvec3>& p, const std::vector<std::uint32_t>& ring,
                        const std::vector<glm::dvec2>& circle) {
    glm::dvec3 s(0), t(0);
    for (std::size_t j = 0; j < ring.size(); ++j) {
        s += circle[j].x * p[ring[j]];
        t += circle[j].y * p[ring[j]];
    }
    return glm::cross(s, t);
}

// Along the boundary, and across it into the surface: the left eigenvectors of the rules around a
// boundary vertex, to the values 1/2 and 3/8 + cos(theta)/4. For three and four neighbours they are
// the masks of Hoppe et al.; for more, those belong to other rules beside the boundary.
glm::dvec3 boundary_normal(const std::vector<glm::dvec3>& p, const glm::dvec3& centre,
                           const std::vector<std::uint32_t>& ring) {
    const std::size_t n = ring.size();
    const glm::dvec3 first = p[ring[0]] - centre, last = p[ring[n - 1]] - centre;
    if (n == 2) return glm::cross(last - first, first + last);
    const double theta = pi / static_cast<double>(n - 1);
    const double end = -std::cos(theta) / std::tan(theta / 2) / (1 + 2 * std::cos(theta));
    glm::dvec3 across = end * (first + last);
    for (std::size_t k = 1; k + 1 < n; ++k)
        across += std::sin(static_cast<double>(k) * theta) * (p[ring[k]] - centre);
    return glm::cross(last - first, across);
}

std::vector<glm::dvec2> circle_of(std::size_t n) {
    std::vector<glm::dvec2> circle(n);
    for (std::size_t j = 0; j < n; ++j) {
        const double angle = 2 * pi * static_cast<double>(j) / static_cast<double>(n);
        circle[j] = {std::cos(angle), std::sin(angle)};
    }
    return circle;
}

// Minus the sum of the normals of the triangles around each vertex, for where tangents vanish.
std::vector<glm::dvec3> ring_normals(const SubdivisionMesh& mesh) {
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
    for (const glm::uvec3& f : mesh.triangles) {
        const auto& p = mesh.positions;
        const glm::dvec3 n = glm::cross(p[f.y] - p[f.x], p[f.z] - p[f.x]);
        for (int k = 0; k < 3; ++k) sums[f[k]] -= n;
    }
    return sums;
}

std::vector<glm::dvec3> limit_normals(const SubdivisionMesh& mesh, const MeshEdges& edges) {
    std::vector<glm::dvec3> normals = ring_normals(mesh);
    std::vector<std::vector<glm::dvec2>> circles(16);
    std::vector<std::uint32_t> ring;
    for (std::uint32_t v = 0; v < normals.size(); ++v) {
        one_ring(mesh.triangles, edges, v, ring);
        const std::size_t n = ring.size();
        if (n >= circles.size()) circles.resize(n + 1);
        if (circles[n].empty()) circles[n] = circle_of(n);
        const glm::dvec3 normal = edges.boundary[v]
                                      ? boundary_normal(mesh.positions, mesh.positions[v], ring)
                                      : inner_normal(mesh.positions, ring, circles[n]);
        if (glm::dot(normal, normal) > 0) normals[v] = normal;
        const double length = glm::length(normals[v]);
        normals[v] = length > 0 ? normals[v] / length : glm::dvec3(0, 0, 1);
    }
    return normals;
}

void drop_stray_vertices(SubdivisionMesh& mesh) {
    std::vector<std::uint32_t> place(mesh.positions.size(), MeshEdges::none);
    std::uint32_t used = 0;
    for (const glm::uvec3& f : mesh.triangles)
        for (int k = 0; k < 3; ++k) place[f[k]] = 0;
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (place[v] == MeshEdges::none) continue;
        mesh.positions[used] = mesh.positions[v];
        place[v] = used++;
    }
    mesh.positions.resize(used);
    for (glm::uvec3& f : mesh.triangles)
        for (int k = 0; k < 3; ++k) f[k] = place[f[k]];
}

std::string touching_fans(const SubdivisionMesh& mesh, const MeshEdges& edges) {
    std::vector<std::uint32_t> ring;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        if (edges.valence[v] == 0) continue;
        one_ring(mesh.triangles, edges, v, ring);
        if (ring.size() != edges.valence[v])
            return "the surface touches itself in vertex " + std::to_string(v);
    }
    return "";
}

}  // namespace

std::string loop_subdivide(SubdivisionMesh& mesh, int levels) {
    MeshEdges edges;
    std::string fault = find_edges(mesh.triangles, mesh.positions.size(), edges);
    if (fault.empty()) fault = touching_fans(mesh, edges);
    if (!fault.empty()) return fault;
    drop_stray_vertices(mesh);
    find_edges(mesh.triangles, mesh.positions.size(), edges);
    for (int level = 0; level < levels; ++level) {
        subdivide_once(mesh, edges);
        find_edges(mesh.triangles, mesh.positions.size(), edges);
    }
    const auto limit_weight = [](std::uint32_t valence) {
        return 1 / (valence + 3 / (8 * ring_weight(valence)));
    };
    mesh.normals = limit_normals(mesh, edges);
    mesh.positions = smoothed(mesh.positions, edges, limit_weight, 0.2);
    return "";
}

}  // namespace lobe
