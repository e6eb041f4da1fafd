// SPDX-License-Identifier: Apache-2.0
// One model's sharpness set so that its lobe is like another's, in one of five senses. All of it
// is measured (lobe_shape.h): any two models that have a lobe at the normal and a parameter that
// shapes it will do.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lab/measure/lobe_shape.h"
#include "lab/settings.h"

namespace lobe {

struct Criterion {
    const char* name;
    double LobeShape::*quantity;
};
extern const std::array<Criterion, 5> criteria;

// A model whose sharpness is to be chosen: the parameters of these places in its table, which take
// the same value; there is one at least.
struct Sharpened {
    BrdfProbe& probe;
    Subject subject;  // the other parameters
    std::vector<std::size_t> parameters;

    const BrdfParameter& row() const { return subject.model.parameters[parameters[0]]; }
    // "n", "nu=nv"
    std::string name() const;
    // Gives the probe a set for each value.
    void set(const std::vector<double>& values) const;
    // The lobes with these values.
    std::vector<LobeShape> shapes(const std::vector<double>& values) const;
    // Values between which solutions are sought, log-spaced.
    std::vector<double> scan() const;
    // Values to show in a table, and fewer for a plot.
    std::vector<double> examples() const;
    std::vector<double> few() const;
};

// The place of the parameter of that name or, where it is empty, of the number that changes the
// width of the lobe most, and with it those of the same range and default that change the lobe too,
// as roughness along the other tangent does. Empty if there is none that shapes a lobe.
std::vector<std::size_t> shaping_parameters(BrdfProbe& probe, const Subject& subject,
                                            const std::string& name = "");

// The same as a Sharpened. Throws Error (usage) where there is none.
Sharpened find_sharpness(BrdfProbe& probe, const Subject& subject, const std::string& name = "");

struct Match {
    double value;                                 // the other model's parameter
    LobeShape shape;                              // its lobe
    std::array<double, criteria.size()> matched;  // this model's parameter; NaN: there is none
};

// For each value of `other`'s parameter, the values of `own`'s that give a lobe of equal
// quantities, each by a search of its own over the logarithm of the parameter.
std::vector<Match> match_lobes(const Sharpened& own, const Sharpened& other,
                               const std::vector<double>& values);

}  // namespace lobe
