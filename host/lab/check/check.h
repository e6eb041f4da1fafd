// SPDX-License-Identifier: Apache-2.0
// Is a reflectance model what it says? The checks, and what they find.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "scene/brdf_table.h"

namespace lobe {

class Device;
class KernelText;

// What float may err by: so many times the conditioning of the same inputs, a few roundings that
// each do as much as theirs; and this part of the value, which adds up where nothing is stiff.
constexpr double allowed_conditionings = 8, allowed_rounding = 2e-5;

// How much of a model's parameters and directions is looked at.
struct CheckEffort {
    std::size_t sets = 36;   // of parameters
    std::size_t edges = 18;  // sets at the edge of the claim to conserve energy
    std::size_t extreme_sets = 200;
    std::vector<double> angles = {0.05, 45, 80, 89.99};  // of incidence, degrees
    std::size_t directions = 48;                         // of each kind, for each set and angle
    std::size_t samples = 40000;                         // for each set and angle
    std::size_t pilot = 2048;                            // samples that shape the cells
    std::size_t lookout = 250;     // points about each place where models have peaks
    std::size_t cells = 96;        // of the hemisphere
    std::size_t nodes = 300000;    // of a quadrature, at most
    double most_unresolved = 0.5;  // share of cases that may be too sharp for it
    double resolution = 5e-4;      // what quadrature must reach to judge by it
    std::size_t furnace_sets = 3;
    std::uint32_t furnace_pixels = 16, furnace_samples = 64;
    std::vector<double> furnace_angles = {20, 75};
    // Whether a claim that is withheld must be seen broken; a few sets may not show it.
    bool both_ways = true;

    // For devices a thousand times slower, such as simulators.
    static CheckEffort reduced();
};

// What one check found of one model. It has either figures, of which the worst must not pass a
// limit, or p-values, of which the least must not fall below the level of the whole family.
struct Finding {
    explicit Finding(std::string name) : check(std::move(name)) {}

    std::string check;
    std::size_t tests = 0;
    std::vector<double> p;  // one a statistical test
    double worst = 0, limit = std::numeric_limits<double>::quiet_NaN();
    std::string where;    // of the worst figure or the least p
    std::string skipped;  // why it was not made, or empty
    std::string note;
    bool passed = true;

    void see(double figure, const std::string& place);
    void see_p(double probability, const std::string& place);
    double least_p() const { return least_; }  // 1 of none

  private:
    double least_ = 1;
};

struct ModelReport {
    std::string model;
    std::vector<Finding> findings;
    std::size_t sets = 0;
    double compile_s = 0, check_s = 0;
    double largest_albedo = 0;            // where energy is conserved
    double largest_weight_deviation = 0;  // standard deviation of the weight over its mean
    bool passed() const;
};

struct CheckOptions {
    CheckEffort effort;
    std::uint64_t seed = 1;
    std::vector<BrdfTable> kernel_models;  // in the furnace's kernel; at least the model itself
};

// All checks of one model. p-values are judged later, with their family.
ModelReport check_model(const Device& device, const KernelText& kernels,
                        const std::vector<BrdfTable>& models, const BrdfTable& model,
                        const CheckOptions& options);

// False alarms of a whole run.
constexpr double check_alpha = 1e-3;

// Judges all p-values of all reports as one family: each test has Sidak's level. Returns the level.
double judge(std::vector<ModelReport>& reports);

}  // namespace lobe
