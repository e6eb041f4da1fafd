// SPDX-License-Identifier: Apache-2.0
// One model's sharpness set so that its lobe is like another's, in one of five senses. All of it
// is measured (lobe_shape.h): any two models that have a lobe at the normal and a parameter that
// shapes it will do.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lab/lobe_shape.h"
#include "lab/settings.h"

namespace lobe {

struct Criterion {
    const char* name;
    double LobeShape::*quantity;
};
extern const std::array<Criterion, 5> criteria;

// A model whose sharpness is to be chosen: the parameter of that place in its table.
struct Sharpened {
    BrdfProbe& probe;
    Subject subject;  // the other parameters
    std::size_t parameter;

    const BrdfParameter& row() const { return subject.model.parameters[parameter]; }
    // The lobes with these values of the parameter.
    std::vector<LobeShape> shapes(const std::vector<double>& values) const;
    // Values between which solutions are sought, log-spaced.
    std::vector<double> scan() const;
    // Values to show, from the bluntest or sharpest end to the other.
    std::vector<double> examples() const;
};

// Takes the parameter of that name or, where it is empty, the number that changes the width of the
// lobe most. Throws Error (usage) if there is none.
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
