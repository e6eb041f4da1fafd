// SPDX-License-Identifier: Apache-2.0
// Spectra as linear sRGB.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace lobe {

// CIE 1931 XYZ to linear sRGB (IEC 61966-2-1, D65 white).
glm::dvec3 rgb_from_xyz(const glm::dvec3& xyz);

// Relative luminance of linear sRGB.
double luminance(const glm::dvec3& rgb);

// XYZ of a spectrum given as wavelength (nm), value pairs with increasing wavelengths, linear
// between them and constant beyond its ends; a spectrum of ones has Y = 1.
glm::dvec3 xyz_from_samples(const std::vector<double>& pairs);

// XYZ of a black body at a temperature in kelvin whose brightest wavelength has the value one.
glm::dvec3 xyz_from_blackbody(double kelvin);

}  // namespace lobe
