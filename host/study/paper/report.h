// SPDX-License-Identifier: Apache-2.0
// What `lobe paper` tells: tables and a verdict to a person, JSON and CSV to programs.
#pragma once

#include <nlohmann/json.hpp>

#include "study/paper/claims.h"

namespace lobe {

struct PaperReport {
    std::string version, scene, scene_hash;
    std::vector<std::string> command;  // as typed
    DeviceInfo device;
    PaperPlan plan;
    bool quick = false;
    std::vector<std::string> replaced;  // types of materials
    PaperExperiment experiment;
    PaperFindings findings;  // of no use without a complete round
    std::vector<Claim> claims;
    double total_seconds = 0;
};

// What was measured, in a few lines: scene, film, runs, what is masked, how models were made alike.
std::string conditions_text(const PaperReport& report);

// What the columns of the error table are, and how the models were made alike.
std::string errors_legend();
std::string footings_legend();

// One paragraph: does the claim hold, where, and how much noise can be cut at equal time.
std::string verdict_sentence(const PaperReport& report);

std::string to_text(const PaperReport& report);
nlohmann::ordered_json to_json(const PaperReport& report);

// A line a run: model, alike_in, sampler, seed, spp, render_s, mse, mse_trimmed, trimmed_share,
// mean_absolute_error. Squared errors are relative, as PictureError's.
std::string to_csv(const PaperReport& report);

// Cells of the tables, for the terminal and for the page alike. The first row is the head.
using Rows = std::vector<std::vector<std::string>>;
Rows error_rows(const PaperReport& report);
Rows ratio_rows(const PaperReport& report);
Rows parameter_rows(const PaperReport& report);
Rows claim_rows(const PaperReport& report);

}  // namespace lobe
