// SPDX-License-Identifier: Apache-2.0
// What `lobe compare` tells: a table and one sentence to a person, JSON and CSV to programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cl/device.h"
#include "study/comparison.h"

namespace lobe {

struct ComparisonReport {
    std::string version;
    std::vector<std::string> command;
    DeviceInfo device;
    ComparisonPlan plan;
    bool by_time = true;                  // the last sentence is of equal time, else of samples
    std::vector<SceneComparison> scenes;  // judged
    // Row by row the geometric mean over scenes; empty with one scene.
    std::vector<Judgement> combined, combined_trimmed;
};

// Judges the scenes and fills in what is combined.
void judge_report(ComparisonReport& report);

// The row of the last sentence: the one with the most samples, or the longest time, for the noise
// is least there. The judgement over all scenes.
std::size_t headline_row(const ComparisonReport& report);
const Judgement& headline(const ComparisonReport& report);

// "At equal time A wins: ..."
std::string verdict_sentence(const ComparisonReport& report);

std::string to_text(const ComparisonReport& report);
nlohmann::ordered_json to_json(const ComparisonReport& report);

// A line a run: scene, table, arm, seed, samples, render_s, mse, mse_trimmed, trimmed_share. Errors
// are those of PictureError.
std::string to_csv(const ComparisonReport& report);

}  // namespace lobe
