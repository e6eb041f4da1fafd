// SPDX-License-Identifier: Apache-2.0
#include "scene/transform.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace lobe {

glm::dmat4 rotation(double degrees, const glm::dvec3& axis) {
    return glm::rotate(glm::dmat4(1), glm::radians(degrees), axis);
}

std::optional<glm::dmat4> look_at(const glm::dvec3& eye, const glm::dvec3& target,
                                  const glm::dvec3& up) {
    const glm::dvec3 view = target - eye;
    const glm::dvec3 side = glm::cross(up, view);
    if (!(glm::length(side) > 1e-12 * glm::length(up) * glm::length(view))) return {};
    const glm::dvec3 z = glm::normalize(view), x = glm::normalize(side), y = glm::cross(z, x);
    const glm::dmat4 camera_to_world(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0),
                                     glm::dvec4(eye, 1));
    return glm::inverse(camera_to_world);
}

std::string transform_fault(const glm::dmat4& m) {
    double norm = 0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return "the transform is not finite";
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] == 0)
        return "projective transforms are not supported";
    const glm::dmat3 linear(m);
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) norm = std::max(norm, std::fabs(linear[c][r]));
    if (!(norm > 0) || !(std::fabs(glm::determinant(linear / norm)) >= 1e-30))
        return "the transform is degenerate: it flattens space";
    return "";
}

bool swaps_handedness(const glm::dmat4& m) { return glm::determinant(glm::dmat3(m)) < 0; }

glm::dvec3 transform_point(const glm::dmat4& m, const glm::dvec3& p) {
    return glm::dvec3(m * glm::dvec4(p, 1)) / m[3][3];
}

glm::dvec3 transform_vector(const glm::dmat4& m, const glm::dvec3& v) {
    return glm::dmat3(m) * v / m[3][3];
}

glm::dmat3 normal_matrix(const glm::dmat4& m) {
    return glm::transpose(glm::inverse(glm::dmat3(m) / m[3][3]));
}

std::optional<double> uniform_scale(const glm::dmat4& m) {
    const glm::dmat3 linear = glm::dmat3(m) / m[3][3];
    const glm::dmat3 square = glm::transpose(linear) * linear;
    const double scale = (square[0][0] + square[1][1] + square[2][2]) / 3;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (std::fabs(square[c][r] - (c == r ? scale : 0)) > 2e-4 * scale) return {};
    return std::cbrt(std::fabs(glm::determinant(linear)));
}

}  // namespace lobe
