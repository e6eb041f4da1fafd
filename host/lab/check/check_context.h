// SPDX-License-Identifier: Apache-2.0
// What the single checks share: the model on the device, its parameter sets, the angles of view.
#pragma once

#include <memory>

#include "base/random.h"
#include "lab/brdf_probe.h"
#include "lab/check/check.h"
#include "lab/parameter_sweep.h"

namespace lobe {

// One parameter set seen from one angle.
struct CheckCase {
    std::uint32_t set;
    double degrees;
    glm::dvec3 wo;
    std::string text;  // "n 100 at 80 deg"
};

struct CheckContext {
    const Device& device;
    const KernelText& kernels;
    const std::vector<BrdfTable>& models;
    const BrdfTable& model;
    const CheckOptions& options;
    BrdfProbe probe;
    std::unique_ptr<BrdfProbe> oracle;  // the double build; none on devices without fp64
    std::vector<ParameterSet> sets;
    std::vector<float> tables;
    std::vector<CheckCase> cases;

    const BrdfClaims& claims(const CheckCase& c) const { return probe.claims()[c.set]; }
};

CheckContext make_check_context(const Device& device, const KernelText& kernels,
                                const std::vector<BrdfTable>& models, const BrdfTable& model,
                                const CheckOptions& options);

// The direction at an angle from the normal, as floats hold it.
glm::dvec3 view_at(double degrees, double azimuth = 0.7);

inline double mean_channel(const glm::dvec3& v) { return (v.x + v.y + v.z) / 3; }

// Samples against densities, and albedos three ways: density, chi-square, albedo, energy, variance.
std::vector<Finding> check_sampling(CheckContext& context, ModelReport& report);
// finite, garbage: everything is a number and nothing is negative, whatever is asked.
std::vector<Finding> check_extremes(CheckContext& context);
// reciprocity, formula, precision, weight.
std::vector<Finding> check_values(CheckContext& context);
// furnace: the mean of a picture is the albedo.
Finding check_furnace(CheckContext& context);

// A claim that is tested both ways: the largest violation where it is made must not pass the limit,
// and where it is withheld somewhere, the largest violation there must.
class ClaimTest {
  public:
    ClaimTest(std::string check, double limit) : finding_(std::move(check)), limit_(limit) {}
    void see(bool claimed, double violation, const std::string& where);
    // `both_ways`: it fails if no violation was seen where the claim is withheld.
    Finding finish(const std::string& claim, bool both_ways);

  private:
    Finding finding_;
    double limit_;
    std::size_t withheld_ = 0;
    double shown_ = 0;
    std::string shown_where_;
};

}  // namespace lobe
