// SPDX-License-Identifier: Apache-2.0
// Stiff and extreme cases of a model: what float makes of the formula as its source prints it and
// of the model's own functions, and what rounding the directions costs any arithmetic.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lab/check/check.h"
#include "lab/settings.h"

namespace lobe {

// Unit vectors in double, both above the horizon; the device gets them rounded to float.
struct StiffPair {
    glm::dvec3 wo, wi;
};

// wi at angles of 1e-8 to pi/2 from the mirror direction of wo, evenly in the logarithm.
std::vector<StiffPair> near_mirror_pairs(std::size_t count, std::uint64_t seed);

// Cosines of wi, of wo and of both down to 1.2e-38, evenly in the logarithm.
std::vector<StiffPair> grazing_pairs(std::size_t count, std::uint64_t seed);

// Errors of one form of f cos theta_i in float, relative to the double build's value for the
// directions before they were rounded; NaN without that build. Below `least_value` they are
// relative to it.
struct FormErrors {
    double worst = 0, median = 0;  // of the finite values
    std::size_t nonfinite = 0, negative = 0;

    static constexpr double least_value = 1e-30;
};

// One set of parameters, asked for many pairs of directions.
struct ExtremesRow {
    double value = 0;                 // of the parameter that is swept
    std::optional<FormErrors> naive;  // NAME_formula, if the model has one
    FormErrors ours;                  // NAME_eval
    double arithmetic = 0;  // worst error of ours relative to double for the rounded directions
    double limit = 0;       // largest relative change of f as directions move by half an ulp
    double excess = 0;      // worst error of ours over what it may be

    bool passed() const { return ours.nonfinite == 0 && ours.negative == 0 && !(excess > 1); }
};

// A model in both builds; `oracle` is none on devices without cl_khr_fp64.
struct ExtremesProbes {
    BrdfProbe& single;
    BrdfProbe* oracle;
    std::vector<float> tables;  // that the parameter sets point into
};

// One row a set of parameters, without its value. Deterministic.
std::vector<ExtremesRow> measure_extremes(const ExtremesProbes& probes,
                                          const std::vector<BrdfRows>& sets,
                                          const std::vector<StiffPair>& pairs);

// A parameter's stiff values under one kind of directions.
struct ExtremesBlock {
    std::string parameter;   // "" for a model without numbers
    std::string directions;  // "near the mirror direction" or "at grazing angles"
    std::string changed;     // "", or the colour that is black: "kd 0"
    std::vector<ExtremesRow> rows;

    bool passed() const;
    double limit() const;  // the largest of its rows
};

struct ExtremesReport {
    std::string model;
    std::size_t pairs = 0;  // of directions, a row
    bool has_reference = false, has_formula = false;
    double compile_s = 0, measure_s = 0;
    std::vector<ExtremesBlock> blocks;

    bool passed() const;
    // Of each parameter and kind of directions: the colours under which directions matter most, and
    // whatever failed.
    std::vector<const ExtremesBlock*> telling() const;
};

// Every number parameter swept over its stiff values, with the colours as the subject has them and
// each in turn at 0, all else as the subject has it.
ExtremesReport report_extremes(const Device& device, const KernelText& kernels,
                               const Subject& subject, std::size_t pairs = 2000);

// The values at which a number parameter is stiff: towards and at the ends of its range, about 0
// and one; where there is no end, to 1e12, the largest float and infinity.
std::vector<double> stiff_values(const BrdfParameter& parameter);

}  // namespace lobe
