// SPDX-License-Identifier: Apache-2.0
// Materials of scene files as reflectance models with their parameters.
#pragma once

#include <string>

#include "scene/context.h"
#include "scene/parameters.h"

namespace lobe {

// The material that a Material or MakeNamedMaterial directive describes; `type` is "plastic" or the
// name of a model, or anything where "string brdf" names the file of one. Throws Error (scene) for
// types and parameters that are unknown, out of range or not supported yet.
Material read_material(const Statement& statement, const std::string& type, const Place& type_place,
                       const ReadContext& context);

// The material of shapes before the first Material directive: half of the light reflected.
Material standard_material(const ReadContext& context);

// The parameters of a model, filled one by one.
class MaterialRows {
  public:
    MaterialRows(const BrdfTable& table) : table_(table), rows_(table.default_rows()) {}

    const std::string& model() const { return table_.name; }
    bool has(const std::string& name) const { return table_.find(name) >= 0; }
    void set(const std::string& name, const glm::dvec3& colour);
    void set(const std::string& name, double number) { set(name, glm::dvec3(number, 0, 0)); }
    const std::vector<std::array<float, 4>>& rows() const { return rows_; }

  private:
    const BrdfTable& table_;
    std::vector<std::array<float, 4>> rows_;
};

// The table of a model that pbrt's materials need. Throws Error (scene) when it is missing.
const BrdfTable& model_table(const ReadContext& context, const std::string& name);

// The model a material type names, compared without case and underscores, or null.
const BrdfTable* find_model(const ReadContext& context, const std::string& type);

// The model of a file that the scene names, read at its first use. Throws Error (scene) as
// read_user_model does.
const BrdfTable& model_of_file(const std::string& file, const Place& place,
                               const ReadContext& context);

// Whether pbrt has a material of that name which lobe reads.
bool is_pbrt_material(const std::string& name);

// Reads the parameters of one of our own models.
MaterialRows read_model(Parameters& parameters, const BrdfTable& table, const ReadContext& context);

// Reads the file that a parameter of kind `table` names, once, into the scene's tables; gives the
// value of its row.
glm::dvec3 read_table(const Parameter& given, const ReadContext& context);

// Puts another model in a material's place where `--replace` asks for it.
void replace_model(Material& material, const ReadContext& context, const Place& place);

// Warns of `--replace` types that no material had.
void check_replacements(const ReadContext& context);

}  // namespace lobe
