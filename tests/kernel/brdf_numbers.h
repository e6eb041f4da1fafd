// SPDX-License-Identifier: Apache-2.0
// What the tests of known numbers share: a model's integrals over the hemisphere on the device, and
// whether a number has the digits that are printed.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "kernel/brdf_grid.h"
#include "kernel/brdf_probe.h"

namespace lobe::test {

// Whether `value` rounds to the number in `printed`, give or take a relative error of `slack`.
inline testing::AssertionResult has_digits(double value, const std::string& printed,
                                           double slack = 3e-6) {
    const auto e = printed.find('e'), point = printed.find('.');
    const double exponent = e == std::string::npos ? 0 : std::atof(printed.c_str() + e + 1);
    const auto end = std::min(e, printed.size());
    const double decimals = point == std::string::npos ? 0 : static_cast<double>(end - point - 1);
    const double half = 0.5 * std::pow(10.0, exponent - decimals);
    const double given = std::atof(printed.c_str());
    if (std::fabs(value - given) <= half * (1 + 1e-9) + slack * std::fabs(value))
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << value << " is not " << printed;
}

// Words of a text, for tables that are written as they are printed.
inline std::vector<std::string> words(const std::string& text) {
    std::vector<std::string> all;
    for (std::size_t at = text.find_first_not_of(" \n"); at != std::string::npos;) {
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        all.push_back(text.substr(at, end - at));
        at = text.find_first_not_of(" \n", end);
    }
    return all;
}

// Integrals over the directions of light, seen from wo.
struct BrdfIntegrals {
    double albedo = 0;           // of f cos
    double lobe = 0;             // of f
    double mass = 0;             // of the density of samples
    double squares_sampled = 0;  // of (f cos)^2 / density: the mean square of a sample's weight
    double squares_cosine = 0;   // the same for samples of density cos / pi

    // Standard deviation of a sample's weight over its mean, in percent.
    double deviation() const { return percent(squares_sampled); }
    double cosine_deviation() const { return percent(squares_cosine); }

  private:
    double percent(double squares) const {
        return 100 * std::sqrt(std::max(0.0, squares / (albedo * albedo) - 1));
    }
};

// `width` is about that of the lobe in 1 - cos. One channel; only directions of cosine > `least`.
inline BrdfIntegrals integrals_of(const ModelProbe<float>& probe, const BrdfValues& values,
                                  const vec3l& wo, Long width, Long least = 0) {
    const HemisphereGrid grid(wo, rings_of_width(width));
    const auto out = probe.eval({values}, std::vector<vec3l>(grid.nodes.size(), wo), grid.nodes);
    BrdfIntegrals all;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double w = static_cast<double>(grid.weights[i]), f = out[i].f.x;
        const double cosine = static_cast<double>(grid.nodes[i].z);
        if (!(cosine > static_cast<double>(least))) continue;
        all.albedo += w * f;
        all.lobe += w * f / cosine;
        all.mass += w * out[i].pdf;
        if (out[i].pdf > 0) all.squares_sampled += w * f * f / out[i].pdf;
        all.squares_cosine += w * f * f / cosine * static_cast<double>(pi);
    }
    return all;
}

inline BrdfIntegrals integrals_at(const ModelProbe<float>& probe, const BrdfValues& values,
                                  double degrees, double n) {
    return integrals_of(probe, values, direction(radians(degrees)), 1 / std::max(n, 1.0));
}

// Albedo of what light from an angle reflects to all sides: the adjoint, f cos theta_o.
inline double light_side_albedo(const ModelProbe<float>& probe, const BrdfValues& values,
                                double degrees, double n) {
    const vec3l wi = direction(radians(degrees));
    const HemisphereGrid grid(wi, rings_of_width(1 / std::max(n, 1.0)));
    const auto out = probe.eval({values}, grid.nodes, std::vector<vec3l>(grid.nodes.size(), wi));
    Long sum = 0;
    for (std::size_t i = 0; i < out.size(); ++i)
        sum += grid.weights[i] * out[i].f.x * grid.nodes[i].z / wi.z;
    return static_cast<double>(sum);
}

}  // namespace lobe::test
