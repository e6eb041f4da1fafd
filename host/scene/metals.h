// SPDX-License-Identifier: Apache-2.0
// Optical constants of the metals that pbrt-v4 knows by name.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace lobe {

// Complex index of refraction eta + i k as linear sRGB: the measured spectra integrated against the
// CIE 1931 observer (over the integral of its y), then XYZ to sRGB. Measurements: Ag, Au, Cu from
// Hagemann, Gudat and Kunz (1975) and Al from Rakic (1995) as collected by luxpop, brass (CuZn)
// from Querry (1985).
struct Metal {
    const char* name;  // as in "metal-Cu-eta"
    glm::dvec3 eta, k;
};

inline constexpr std::size_t metal_count = 5;
inline const std::array<Metal, metal_count> metals{{
    {"Ag", {0.155264649, 0.116723297, 0.138380696}, {4.828343322, 3.122245928, 2.147050445}},
    {"Al", {1.657459960, 0.880368958, 0.521228735}, {9.223869200, 6.269523248, 4.837001228}},
    {"Au", {0.143118956, 0.374957043, 1.442478557}, {3.983160425, 2.385720748, 1.603215290}},
    {"Cu", {0.200437697, 0.924033430, 1.102211953}, {3.912948503, 2.452847702, 2.142187955}},
    {"CuZn", {0.519769060, 0.488506024, 1.042009808}, {4.330582577, 2.548105965, 1.591890596}},
}};

}  // namespace lobe
