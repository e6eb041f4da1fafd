// SPDX-License-Identifier: Apache-2.0
// What device arithmetic is measured against: long double, and quadrature.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

namespace lobe::test {

using Long = long double;
using vec3l = glm::vec<3, long double>;

constexpr Long pi = 3.14159265358979323846264338327950288L;

// |value - exact| in units of the last place of a float near `exact`.
inline double ulp_error(float value, Long exact) {
    if (std::isnan(value) || std::isnan(exact))
        return std::isnan(value) == std::isnan(exact) ? 0 : INFINITY;
    if (std::isinf(value))
        return std::fabs(exact) > 0x1.ffffffp127L && (value > 0) == (exact > 0) ? 0 : INFINITY;
    const int exponent = exact == 0 ? -126 : std::max(std::ilogb(exact), -126);
    return static_cast<double>(std::fabs(static_cast<Long>(value) - exact) /
                               std::scalbn(1.0L, exponent - 23));
}

// |value - exact| / |exact|, and 0 where both are zero.
inline double relative_error(Long value, Long exact) {
    if (value == exact) return 0;
    return exact == 0 ? INFINITY : static_cast<double>(std::fabs((value - exact) / exact));
}

// Integral of f over [a, b] by the tanh-sinh rule (Takahasi, Mori, 1974): for smooth functions near
// the precision of long double, and it does not mind singular ends.
template <typename Function>
Long integrate(const Function& f, Long a, Long b, int steps = 128) {
    const Long half = 0.5L * (b - a), middle = 0.5L * (a + b), reach = 4.5L;
    const Long h = 2 * reach / steps;
    Long sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const Long t = -reach + h * i;
        const Long u = 0.5L * pi * std::sinh(t), cosine = std::cosh(u);
        const Long weight = 0.5L * pi * std::cosh(t) / (cosine * cosine);
        const Long x = middle + half * std::tanh(u);
        if (weight > 0 && x > std::min(a, b) && x < std::max(a, b)) sum += weight * f(x);
    }
    return sum * h * half;
}

// Integral of f(vec3l) over the hemisphere z > 0 in solid angle.
template <typename Function>
Long integrate_hemisphere(const Function& f, int steps = 128) {
    return integrate(
        [&](Long z) {
            const Long r = std::sqrt((1 - z) * (1 + z));
            Long ring = 0;  // the trapezium rule is exact for what is smooth and periodic
            for (int i = 0; i < steps; ++i) {
                const Long phi = 2 * pi * (i + 0.5L) / steps;
                ring += f(vec3l(r * std::cos(phi), r * std::sin(phi), z));
            }
            return ring * 2 * pi / steps;
        },
        0, 1, steps);
}

}  // namespace lobe::test
