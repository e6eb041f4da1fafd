// SPDX-License-Identifier: Apache-2.0
#include "scene/colour.h"

#include <algorithm>
#include <cmath>

namespace lobe {

namespace {

// One lobe of Wyman, Sloan and Shirley's fit: a Gaussian with its own width on each side.
double lobe_of(double nm, double peak, double below, double above) {
    const double t = (nm - peak) * (nm < peak ? below : above);
    return std::exp(-0.5 * t * t);
}

// "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2), 2013,
// multi-lobe fit of the 1931 observer.
glm::dvec3 observer(double nm) {
    return {
        0.362 * lobe_of(nm, 442.0, 0.0624, 0.0374) + 1.056 * lobe_of(nm, 599.8, 0.0264, 0.0323) -
            0.065 * lobe_of(nm, 501.1, 0.0490, 0.0382),
        0.821 * lobe_of(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe_of(nm, 530.9, 0.0613, 0.0322),
        1.217 * lobe_of(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe_of(nm, 459.0, 0.0385, 0.0725)};
}

// Integral of a spectrum against the observer, over that of the observer's luminance.
template <typename Spectrum>
glm::dvec3 integrate(const Spectrum& spectrum) {
    glm::dvec3 sum(0);
    double white = 0;
    for (int nm = 360; nm <= 830; ++nm) {
        const glm::dvec3 weight = observer(nm);
        sum += weight * spectrum(static_cast<double>(nm));
        white += weight.y;
    }
    return sum / white;
}

}  // namespace

glm::dvec3 rgb_from_xyz(const glm::dvec3& xyz) {
    return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
            -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
            0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

double luminance(const glm::dvec3& rgb) {
    return glm::dot(rgb, glm::dvec3(0.2126729, 0.7151522, 0.0721750));
}

glm::dvec3 xyz_from_samples(const std::vector<double>& pairs) {
    const std::size_t count = pairs.size() / 2;
    return integrate([&](double nm) {
        std::size_t i = 0;
        while (i < count && pairs[2 * i] < nm) ++i;
        if (i == 0) return pairs[1];
        if (i == count) return pairs[2 * count - 1];
        const double t = (nm - pairs[2 * i - 2]) / (pairs[2 * i] - pairs[2 * i - 2]);
        return pairs[2 * i - 1] * (1 - t) + pairs[2 * i + 1] * t;
    });
}

glm::dvec3 xyz_from_blackbody(double kelvin) {
    constexpr double second_constant = 1.438776877e7;  // h c / k in nm K
    constexpr double wien = 2.897771955e6;             // in nm K
    const auto planck = [&](double nm) {
        return std::pow(nm, -5) / std::expm1(second_constant / (nm * kelvin));
    };
    const double peak = planck(wien / kelvin);
    return integrate([&](double nm) { return planck(nm) / peak; });
}

}  // namespace lobe
