// SPDX-License-Identifier: Apache-2.0
// The page of a model, in Markdown: all of it is its own file's or measured.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lab/check/check.h"
#include "lab/page/model_table.h"
#include "lab/plot/sphere_scene.h"

namespace lobe {

// One check as the page shows it.
struct CheckLine {
    std::string check, verdict, found, remark;
};
std::vector<CheckLine> check_lines(const ModelReport& report);
// From what `lobe brdf check --json` writes of a model; empty if it is not there. Throws Error
// (scene) at `where` for a file that is none of those.
std::vector<CheckLine> check_lines(const nlohmann::json& file, const std::string& model,
                                   const std::string& where);

struct ModelPage {
    ModelTable table;
    std::vector<CheckLine> checks;
    std::string checked_by;  // "lobe brdf check NAME --grid reduced"
    std::string device;
    std::string polar, sphere;  // file names of the plots; empty: none
    Estimate sphere_picture;
};

std::string to_markdown(const ModelPage& page);

// The page that leads to the others: models with their formulas.
std::string index_page(const std::vector<BrdfTable>& models);

}  // namespace lobe
