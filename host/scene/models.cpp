// SPDX-License-Identifier: Apache-2.0
// Our own reflectance models as materials, read by their tables, and --replace.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "scene/materials.h"

namespace lobe {

namespace {

const BrdfTable* find_plain(const std::vector<BrdfTable>& models, const std::string& name) {
    for (const BrdfTable& table : models)
        if (same_model_name(table.name, name)) return &table;
    return nullptr;
}

std::vector<std::string> model_names(const std::vector<BrdfTable>& models) {
    std::vector<std::string> names;
    for (const BrdfTable& table : models) names.push_back(table.name);
    return names;
}

double choice_of(const Parameter& given, const BrdfParameter& row) {
    const bool text = given.type == ParameterType::string || given.type == ParameterType::boolean;
    if (!text || given.strings.size() != 1)
        fail(given.place,
             "parameter \"" + given.name + "\" wants one string, has " + given.spelling,
             choices(row.choices));
    const auto found = std::find(row.choices.begin(), row.choices.end(), given.strings[0]);
    if (found == row.choices.end())
        fail(given.values_place,
             "parameter \"" + given.name + "\" has no choice \"" + given.strings[0] + "\"",
             suggestion(given.strings[0], row.choices));
    return static_cast<double>(found - row.choices.begin());
}

glm::dvec3 value_of(Parameters& parameters, const Parameter& given, const BrdfParameter& row,
                    const ReadContext& context) {
    if (row.kind == BrdfParameterKind::table) return read_table(given, context);
    if (row.kind == BrdfParameterKind::choice) return {choice_of(given, row), 0, 0};
    if (row.kind == BrdfParameterKind::color) {
        const glm::dvec3 colour = parameters.colour_of(given);
        parameters.check_range(colour, row.lowest, row.highest, row.meaning);
        parameters.check_float(colour);
        return colour;
    }
    const double value = parameters.number_of(given, std::isinf(row.highest));
    if (row.kind == BrdfParameterKind::integer && value != std::floor(value))
        fail(given.values_place,
             "parameter \"" + given.name + "\" wants a whole number, has " + show(value));
    parameters.check_range(value, row.lowest, row.highest, row.meaning);
    parameters.check_float(glm::dvec3(value));
    return {value, 0, 0};
}

}  // namespace

void MaterialRows::set(const std::string& name, const glm::dvec3& colour) {
    const int place = table_.find(name);
    if (place < 0)
        throw Error(ExitCode::scene,
                    "model '" + table_.name + "' has no parameter '" + name + "' in its table",
                    table_.file);
    rows_[static_cast<std::size_t>(place)] = {static_cast<float>(colour.x),
                                              static_cast<float>(colour.y),
                                              static_cast<float>(colour.z), 0};
}

const BrdfTable& model_table(const ReadContext& context, const std::string& name) {
    for (const BrdfTable& table : context.models)
        if (table.name == name) return table;
    for (const UserModel& model : context.scene.models)
        if (model.table.name == name) return model.table;
    throw Error(ExitCode::scene,
                "the model '" + name + "' is missing from the kernels' brdf folder",
                context.scene.path, choices(model_names(context.models)));
}

const BrdfTable* find_model(const ReadContext& context, const std::string& type) {
    return find_plain(context.models, type);
}

MaterialRows read_model(Parameters& parameters, const BrdfTable& table,
                        const ReadContext& context) {
    MaterialRows rows(table);
    for (const BrdfParameter& row : table.parameters)
        if (const Parameter* given = parameters.find({row.name.c_str()}))
            rows.set(row.name, value_of(parameters, *given, row, context));
        else if (row.kind == BrdfParameterKind::table)
            fail(parameters.place(),
                 parameters.title() + " lacks its parameter \"" + row.name + "\"", row.meaning);
    return rows;
}

const BrdfTable& model_of_file(const std::string& file, const Place& place,
                               const ReadContext& context) {
    const std::string path = resolve_path(context, file, place);
    if (const BrdfTable* const given = find_user_model(context.models, path)) return *given;
    std::vector<BrdfTable> models = context.models;
    for (const UserModel& model : context.scene.models) models.push_back(model.table);
    if (const BrdfTable* const seen = find_user_model(models, path))
        return model_table(context, seen->name);
    UserModel model = read_user_model(path, models);
    model.where = to_string(place);
    context.scene.models.push_back(std::move(model));
    return context.scene.models.back().table;
}

// The model that --replace names.
static const BrdfTable& replacement(const ReadContext& context, const std::string& name) {
    if (const BrdfTable* const table = find_plain(context.models, name)) {
        for (const BrdfParameter& row : table->parameters)
            if (row.kind == BrdfParameterKind::table)
                throw Error(ExitCode::usage, "--replace cannot take the model '" + name + "'", "",
                            "it needs a file, " + row.name + ": give it in the scene");
        return *table;
    }
    throw Error(ExitCode::usage, "--replace names an unknown model '" + name + "'", "",
                suggestion(name, model_names(context.models)) + "; --brdf FILE.cl adds your own");
}

// What --replace carries over must be in the range of the model that takes it.
static void check_replaced(const std::array<float, 4>& values, const BrdfParameter& row,
                           const std::string& model, const Place& place) {
    for (std::size_t i = 0; i < (row.kind == BrdfParameterKind::color ? 3 : 1); ++i)
        if (!(values[i] >= static_cast<float>(row.lowest) &&
              values[i] <= static_cast<float>(row.highest)))
            fail(place,
                 "--replace gives " + row.name + " = " + show(values[i]) + " to the model '" +
                     model + "', which takes it from " + show(row.lowest) + " to " +
                     show(row.highest),
                 row.name == "n" ? "set it with --n" : "change the scene's value");
}

void replace_model(Material& material, const ReadContext& context, const Place& place) {
    const auto& pairs = context.options.replace;
    const auto pair = std::find_if(pairs.begin(), pairs.end(), [&](const auto& candidate) {
        return candidate.first == material.type;
    });
    if (pair == pairs.end()) return;
    const BrdfTable* const table = &replacement(context, pair->second);
    const BrdfTable& old = model_table(context, material.brdf);
    if (old.find("kd") < 0)
        fail(place,
             "--replace cannot take the place of material \"" + material.type +
                 "\", which has no diffuse part",
             "it can for matte, diffuse, plastic and the models with kd");
    Material fresh{table->name, table->default_rows(), material.type, material.where};
    for (std::size_t i = 0; i < table->parameters.size(); ++i) {
        const BrdfParameter& row = table->parameters[i];
        const int from = old.find(row.name);
        const bool same =
            from >= 0 && old.parameters[static_cast<std::size_t>(from)].kind == row.kind;
        if (row.name == "n" && context.options.replace_n) {
            fresh.rows[i] = {static_cast<float>(*context.options.replace_n), 0, 0, 0};
        } else if (same) {
            fresh.rows[i] = material.rows[static_cast<std::size_t>(from)];
        } else if (row.name == "ks") {
            fresh.rows[i] = {0, 0, 0, 0};
        }
        check_replaced(fresh.rows[i], row, pair->second, place);
    }
    material = std::move(fresh);
}

void check_replacements(const ReadContext& context) {
    for (const auto& pair : context.options.replace) {
        replacement(context, pair.second);
        const auto& materials = context.scene.materials;
        const bool found = std::any_of(materials.begin(), materials.end(),
                                       [&](const Material& m) { return m.type == pair.first; });
        if (!found)
            context.scene.warnings.push_back("--replace " + pair.first + "=" + pair.second +
                                             ": no material of the scene is of that type");
    }
}

}  // namespace lobe
