// SPDX-License-Identifier: Apache-2.0
// The unknowns of a fit: a model's parameters as an optimiser likes them.
#pragma once

#include "base/random.h"
#include "lab/settings.h"

namespace lobe {

// One channel of a colour, or a number. The optimiser's x is the parameter divided by its scale or,
// for positive parameters without end such as a lobe's exponent, its logarithm.
struct Unknown {
    std::size_t row;
    int channel;
    bool logarithmic;
    double scale;
    double lowest, highest;              // of x
    double least_start, greatest_start;  // of the parameter; starts lie evenly in its logarithm
                                         // where the first is positive

    double parameter(double x) const;
    double x_of(double parameter) const;
};

// How bright the data are, by channel: sets the scale of colours without end.
struct Brightness {
    glm::dvec3 typical, largest;
};

std::vector<Unknown> unknowns_of(const Subject& subject, const std::vector<std::string>& held,
                                 const Brightness& data);

// A model's rows with the unknowns at x.
BrdfRows rows_at(const Subject& subject, const std::vector<Unknown>& unknowns, const double* x);

// Starting points, each a value for each unknown: a Latin hypercube, in which the channels of a
// colour go together.
std::vector<std::vector<double>> starting_points(const std::vector<Unknown>& unknowns, int count,
                                                 std::uint64_t seed);

}  // namespace lobe
