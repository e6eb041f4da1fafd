// SPDX-License-Identifier: Apache-2.0
#include "build/filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "shared/frame.h"

namespace lobe {
namespace {

// Mitchell and Netravali, "Reconstruction Filters in Computer Graphics", 1988; x in [0, 2].
double mitchell(double x, double b, double c) {
    x = std::abs(x);
    if (x >= 2) return 0;
    if (x > 1)
        return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x +
                (8 * b + 24 * c)) /
               6;
    return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
}

constexpr int cells = 1 << 16;  // of the integration over one half width; |f| is even

struct Axis {
    std::vector<double> cumulative;  // of |f| from 0 to the half width
    double absolute = 0, signed_sum = 0;
    double negative = std::numeric_limits<double>::infinity();  // part of |f| within its first zero
    bool rises_again = false;                                   // positive beyond a negative part
};

Axis integrate(const Filter& filter, double radius) {
    Axis axis;
    axis.cumulative.push_back(0);
    for (int i = 0; i < cells; ++i) {
        const double offset = radius * (i + 0.5) / cells;
        const double value = filter_value(filter, radius, offset);
        if (value < 0) axis.negative = std::min(axis.negative, axis.absolute);
        if (value > 0 && !std::isinf(axis.negative)) axis.rises_again = true;
        axis.absolute += std::abs(value);
        axis.signed_sum += value;
        axis.cumulative.push_back(axis.absolute);
    }
    axis.negative /= axis.absolute;
    return axis;
}

// The camera knows one place from which a filter is negative, and divides by its integral.
void check(const Axis& axis) {
    if (!(axis.absolute > 0 && axis.signed_sum > 1e-6 * axis.absolute))
        throw Error(ExitCode::scene, "the pixel filter has no positive integral", "",
                    "its width and its other parameters do not fit each other");
    if (axis.rises_again)
        throw Error(ExitCode::scene, "the pixel filter turns positive again beyond a negative part",
                    "", "mitchell with B and C from 0 to 1 does not");
}

// Offset in half widths at which the cumulative distribution of |f| over [0, 1] reaches `part`.
double invert(const Axis& axis, double part) {
    const double target = part * axis.absolute;
    const auto above = std::upper_bound(axis.cumulative.begin(), axis.cumulative.end(), target);
    if (above == axis.cumulative.end()) return 1;
    const auto i = above - axis.cumulative.begin() - 1;
    const double low = axis.cumulative[i], high = *above;
    return (static_cast<double>(i) + (target - low) / (high - low)) / cells;
}

}  // namespace

double filter_value(const Filter& filter, double radius, double offset) {
    const double x = std::abs(offset);
    if (x > radius) return 0;
    switch (filter.kind) {
        case FilterKind::box:
            return 1;
        case FilterKind::triangle:
            return radius - x;
        case FilterKind::gaussian:
            return std::max(
                0.0, std::exp(-filter.alpha * x * x) - std::exp(-filter.alpha * radius * radius));
        case FilterKind::mitchell:
            return mitchell(2 * x / radius, filter.b, filter.c);
    }
    return 0;
}

FilterTable tabulate_filter(const Filter& filter) {
    const Axis x = integrate(filter, filter.radius_x), y = integrate(filter, filter.radius_y);
    check(x);
    check(y);
    FilterTable table;
    table.negative_x = x.negative;
    table.negative_y = y.negative;
    table.weight = x.absolute / x.signed_sum * (y.absolute / y.signed_sum);
    for (const Axis* axis : {&x, &y}) {
        for (int i = 0; i < LOBE_FILTER_NODES; ++i) {
            const double v = static_cast<double>(i) / (LOBE_FILTER_NODES - 1);
            table.nodes.push_back(static_cast<float>(invert(*axis, (1 - v) * (1 + v))));
        }
    }
    return table;
}

}  // namespace lobe
