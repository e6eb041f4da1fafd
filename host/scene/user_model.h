// SPDX-License-Identifier: Apache-2.0
// A reflectance model of the user's own: a file that keeps the contract of kernels/brdf/README.md.
#pragma once

#include <string>
#include <vector>

#include "scene/brdf_table.h"

namespace lobe {

struct UserModel {
    BrdfTable table;  // its file: the path as typed, or as the scene leads to it
    std::string text;
    std::string where;  // FILE:LINE:COL of the scene that names the file, or empty
};

// Reads the file. `models` are those there are already. Throws Error (scene) at FILE:LINE:COL of
// the file for a table that is malformed, and for a model's name that is taken, with both files.
UserModel read_user_model(const std::string& file, const std::vector<BrdfTable>& models);

// The model of `models` that is the user's own and comes from this file, however it is named; or
// null.
const BrdfTable* find_user_model(const std::vector<BrdfTable>& models, const std::string& file);

// Whether two names mean the same model: "ModifiedPhong", "modified_phong" and "modifiedphong" do.
bool same_model_name(const std::string& a, const std::string& b);

}  // namespace lobe
