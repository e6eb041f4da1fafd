// SPDX-License-Identifier: Apache-2.0
// Who is next to whom in a triangle mesh, in flat arrays.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lobe {

// Half-edge 3 f + k runs from corner k of triangle f to the next corner.
struct MeshEdges {
    static constexpr std::uint32_t none = 0xffffffffu;

    struct Edge {
        std::uint32_t from, to;       // as its first half-edge runs
        std::uint32_t first, second;  // its half-edges; second is none on the boundary
        bool boundary() const { return second == none; }
    };

    std::vector<Edge> edges;
    std::vector<std::uint32_t> edge_of;  // of each half-edge
    std::vector<std::uint32_t>
        outgoing;                        // a half-edge from each vertex: a boundary one if there is
    std::vector<std::uint32_t> valence;  // edges at each vertex
    std::vector<std::uint8_t> boundary;  // boundary edges at each vertex: 0 or 2

    std::uint32_t twin(std::uint32_t half) const {
        const Edge& edge = edges[edge_of[half]];
        return edge.first == half ? edge.second : edge.first;
    }
};

inline std::uint32_t next_half(std::uint32_t half) { return half % 3 == 2 ? half - 2 : half + 1; }
inline std::uint32_t previous_half(std::uint32_t half) { return next_half(next_half(half)); }

// Fills `edges` for a mesh without stray vertices. Returns what keeps the mesh from being a
// manifold whose triangles agree in orientation, or "".
std::string find_edges(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                       MeshEdges& edges);

// The neighbours of a vertex: clockwise (against the triangles' orientation) from anywhere inside
// the mesh; on the boundary counter-clockwise from one boundary edge to the other.
void one_ring(const std::vector<glm::uvec3>& triangles, const MeshEdges& edges,
              std::uint32_t vertex, std::vector<std::uint32_t>& ring);

}  // namespace lobe
