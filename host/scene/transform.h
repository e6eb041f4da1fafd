// SPDX-License-Identifier: Apache-2.0
// Affine transforms in double, as scene files write them.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace lobe {

// Rotation by an angle in degrees about an axis of any length but zero.
glm::dmat4 rotation(double degrees, const glm::dvec3& axis);

// World to camera for an eye looking at a point, in pbrt's left-handed camera space. Nothing where
// the points coincide or `up` is parallel to the view.
std::optional<glm::dmat4> look_at(const glm::dvec3& eye, const glm::dvec3& target,
                                  const glm::dvec3& up);

// What makes a matrix unfit as a transform (degenerate, not finite, projective), or "".
std::string transform_fault(const glm::dmat4& m);

// Whether the transform turns right-handed axes into left-handed ones.
bool swaps_handedness(const glm::dmat4& m);

glm::dvec3 transform_point(const glm::dmat4& m, const glm::dvec3& p);
glm::dvec3 transform_vector(const glm::dmat4& m, const glm::dvec3& v);

// The matrix that transforms normals: the inverse transpose of the linear part.
glm::dmat3 normal_matrix(const glm::dmat4& m);

// The factor by which the transform scales lengths if it scales all alike (to 1e-4), else nothing.
std::optional<double> uniform_scale(const glm::dmat4& m);

}  // namespace lobe
