// SPDX-License-Identifier: Apache-2.0
// Measured reflectance of a surface that looks the same however it is turned: a table over the
// angles of half and difference vector (S. Rusinkiewicz, "A new change of variables for efficient
// BRDF representation", 1998).
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lobe {

// Cell (i, j, k) of `counts` lies about theta_h = 90 ((i + 1/2) / counts[0])^2, theta_d = 90 (j +
// 1/2) / counts[1] and phi_d = 180 (k + 1/2) / counts[2] degrees: fine where peaks are.
struct MeasuredBrdf {
    std::array<std::uint32_t, 3> counts{};
    std::vector<glm::vec3> values;  // f in 1/sr, phi_d running fastest; NaN where there is no data

    std::size_t cells() const { return values.size(); }
};

// Limits of a table: cells along one axis, cells in all, and the largest value.
constexpr std::uint32_t most_cells_along = 4096;
constexpr std::uint32_t most_cells = 1u << 25;
constexpr float largest_measured_value = 1e30f;

// Unit vectors of a pair of directions; z may be negative.
struct DirectionPair {
    glm::dvec3 wo, wi;
};

// The directions at the middle of a cell, the half vector in the plane y = 0.
DirectionPair directions_at(const MeasuredBrdf& table, std::size_t cell);

// Values where there was no data: of neighbouring cells, spreading from where there is some. Throws
// Error (scene) at `where` if there is none at all.
void fill_gaps(MeasuredBrdf& table, const std::string& where);

// f between the middles of cells, as kernels/brdf/measured.h finds it. No value may be missing.
glm::dvec3 interpolate(const MeasuredBrdf& table, const glm::dvec3& wo, const glm::dvec3& wi);

// The largest albedo of a channel found over ten angles of incidence. No value may be missing.
double largest_albedo(const MeasuredBrdf& table);

// The table as the device reads it (kernels/brdf/measured.h says how), with its sampling density.
// No value may be missing.
std::vector<float> lay_out(const MeasuredBrdf& table);

// A glossy material of 5 x 5 x 5 cells from a formula; laid out, it is what a model that needs a
// table is checked with.
MeasuredBrdf made_up_material();
std::vector<float> made_up_table();

}  // namespace lobe
