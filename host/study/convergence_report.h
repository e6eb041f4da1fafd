// SPDX-License-Identifier: Apache-2.0
// What `lobe converge` tells: tables to a person, JSON and CSV to programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "study/convergence.h"

namespace lobe {

// What the whole of a command has in common.
struct ConvergenceResults {
    std::string version;
    std::vector<std::string> command;
    std::vector<ConvergenceReport> scenes;
};

// Whether something other than chance makes the picture differ from the reference.
struct BiasVerdict {
    // In standard errors: difference of the image's mean and bias squared, both of the mean picture
    // of the last level's seeds; and b2, which counts for independent samples only, since others do
    // not go as v / N.
    double mean_z = 0, squared_z = 0, floor_z = 0;
    bool floor_counts = false;
    bool found = false;  // by any, at a level of .003 over all
    std::string sentence;
};
BiasVerdict judge_bias(const ConvergenceReport& report);

// One scene: what was rendered, a table of its levels, and what they say.
std::string to_text(const ConvergenceReport& report);
// A line a scene.
std::string summary_text(const std::vector<ConvergenceReport>& reports);

// "schema" 1; numbers that are not known are null.
nlohmann::ordered_json to_json(const ConvergenceResults& results);

// A line a render: scene, seed, spp, wall_s, compile_s, bvh_s, upload_s, mse0, mse_ref, bias2,
// relmse, relmse_trim, smape, max, nonfinite, negative, hash.
std::string to_csv(const ConvergenceResults& results);

}  // namespace lobe
