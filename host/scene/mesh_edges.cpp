// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh_edges.h"

#include <algorithm>

namespace lobe {

namespace {

constexpr std::uint32_t none = MeshEdges::none;

std::uint32_t start_of(const std::vector<glm::uvec3>& triangles, std::uint32_t half) {
    return triangles[half / 3][static_cast<int>(half % 3)];
}

// Half-edges grouped by the smaller of their vertices (a counting sort).
std::vector<std::uint32_t> group_half_edges(const std::vector<glm::uvec3>& triangles,
                                            std::size_t vertices) {
    const auto lower = [&](std::uint32_t half) {
        return std::min(start_of(triangles, half), start_of(triangles, next_half(half)));
    };
    const auto count = static_cast<std::uint32_t>(3 * triangles.size());
    std::vector<std::uint32_t> begin(vertices + 1, 0), order(count);
    for (std::uint32_t half = 0; half < count; ++half) ++begin[lower(half) + 1];
    for (std::size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
    for (std::uint32_t half = 0; half < count; ++half) order[begin[lower(half)]++] = half;
    return order;
}

std::string show_edge(std::uint32_t a, std::uint32_t b) {
    return "the edge of vertices " + std::to_string(a) + " and " + std::to_string(b);
}

// Pairs half-edges into edges.
std::string pair_half_edges(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                            MeshEdges& mesh) {
    std::vector<std::uint32_t> group_of(vertices, none), edge_to(vertices, none);
    for (const std::uint32_t half : group_half_edges(triangles, vertices)) {
        const std::uint32_t a = start_of(triangles, half);
        const std::uint32_t b = start_of(triangles, next_half(half));
        const std::uint32_t lower = std::min(a, b), upper = std::max(a, b);
        if (a == b)
            return "triangle " + std::to_string(half / 3) + " has vertex " + std::to_string(a) +
                   " twice";
        if (group_of[upper] != lower) {
            group_of[upper] = lower;
            edge_to[upper] = static_cast<std::uint32_t>(mesh.edges.size());
            mesh.edges.push_back({a, b, half, none});
        } else {
            MeshEdges::Edge& edge = mesh.edges[edge_to[upper]];
            if (!edge.boundary()) return "more than two triangles share " + show_edge(a, b);
            if (edge.from == a) return "two triangles wind differently at " + show_edge(a, b);
            edge.second = half;
        }
        mesh.edge_of[half] = edge_to[upper];
    }
    return "";
}

}  // namespace

std::string find_edges(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                       MeshEdges& mesh) {
    mesh = {};
    mesh.edges.reserve(triangles.size() * 3 / 2 + 8);
    mesh.edge_of.resize(3 * triangles.size());
    const std::string fault = pair_half_edges(triangles, vertices, mesh);
    if (!fault.empty()) return fault;
    mesh.valence.assign(vertices, 0);
    mesh.boundary.assign(vertices, 0);
    mesh.outgoing.assign(vertices, none);
    for (const MeshEdges::Edge& edge : mesh.edges) {
        for (const std::uint32_t v : {edge.from, edge.to}) {
            ++mesh.valence[v];
            if (edge.boundary() && ++mesh.boundary[v] > 2)
                return "the surface touches itself in vertex " + std::to_string(v);
        }
        if (edge.boundary() || mesh.outgoing[edge.from] == none)
            mesh.outgoing[edge.from] = edge.first;
        if (!edge.boundary() && mesh.outgoing[edge.to] == none)
            mesh.outgoing[edge.to] = edge.second;
    }
    return "";
}

void one_ring(const std::vector<glm::uvec3>& triangles, const MeshEdges& mesh, std::uint32_t vertex,
              std::vector<std::uint32_t>& ring) {
    ring.clear();
    const std::uint32_t start = mesh.outgoing[vertex];
    std::uint32_t half = start;
    if (mesh.boundary[vertex]) {
        ring.push_back(start_of(triangles, next_half(half)));
        while (half != none) {
            const std::uint32_t into = previous_half(half);
            ring.push_back(start_of(triangles, into));
            half = mesh.twin(into);
        }
    } else {
        do {
            ring.push_back(start_of(triangles, next_half(half)));
            half = next_half(mesh.twin(half));
        } while (half != start);
    }
}

}  // namespace lobe
