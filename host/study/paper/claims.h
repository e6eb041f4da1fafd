// SPDX-License-Identifier: Apache-2.0
// The paper's claims about its model, each judged by measured numbers.
#pragma once

#include "study/paper/findings.h"

namespace lobe {

std::string to_text(Holds holds);  // "HOLDS", "DOES NOT HOLD", "HOLDS ONLY IF", "UNDECIDED"

struct Claim {
    std::string key;        // "slower_darkening"
    std::string statement;  // what is claimed
    Holds holds = Holds::undecided;
    std::string condition;  // of only_if: "lobe = abs"
    std::string figures;    // what decides
};

// The lobe of a model: kd = 0, ks = 1.
struct LobeVariant {
    std::string model;
    double n = 100;
    int reading = 0;         // of the rational one: clamp, abs, listing
    bool normalize = false;  // ks is then the albedo at normal incidence
};

struct DirectionsPair {
    glm::dvec3 wo, wi;
};

// f in 1/sr, not times the cosine, of every pair.
using LobeValues =
    std::function<std::vector<double>(const LobeVariant&, const std::vector<DirectionsPair>&)>;

// Asked of the device, in double where it can; both must outlive the result.
LobeValues lobe_values_on(const Device& device, const KernelText& kernels);

// Those of the model: slower darkening than cos^n and than Phong's BRDF; larger n, less light off
// the mirror direction; n = 0 diffuse; n = infinity a mirror; listing equals formula.
std::vector<Claim> judge_model_claims(const LobeValues& values);

// Those of the experiment: equal time, lower error. Undecided with fewer than two complete rounds.
std::vector<Claim> judge_experiment_claims(const PaperExperiment& experiment,
                                           const PaperFindings& findings);

}  // namespace lobe
