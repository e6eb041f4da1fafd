// SPDX-License-Identifier: Apache-2.0
#include "scene/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scene/colour.h"

namespace lobe {

Parameters::Parameters(const Statement& statement, const ReadContext& context, std::string title)
    : statement_(statement),
      context_(context),
      title_(title.empty() ? statement.title() : std::move(title)),
      used_(statement.parameters.size(), false) {
    std::set<std::string> seen;
    for (const Parameter& parameter : statement.parameters)
        if (!seen.insert(parameter.name).second)
            context.fault(parameter.place,
                          "parameter \"" + parameter.name + "\" of " + title_ + " is given twice",
                          "leave out one");
}

const Parameter* Parameters::find(Names names) {
    last_ = nullptr;
    for (const char* name : names) {
        known_.emplace_back(name);
        for (std::size_t i = 0; i < used_.size(); ++i) {
            if (statement_.parameters[i].name != name) continue;
            used_[i] = true;
            if (!last_) last_ = &statement_.parameters[i];
        }
    }
    return last_;
}

void Parameters::wrong_type(const Parameter& parameter, const std::string& wanted) const {
    fail(parameter.place, "parameter \"" + parameter.name + "\" of " + title_ + " wants " + wanted +
                              ", has " + parameter.spelling);
}

const Texture& Parameters::texture(const Parameter& parameter) const {
    const auto& textures = context_.names->textures;
    if (parameter.strings.size() != 1) wrong_type(parameter, "one texture");
    const auto found = textures.find(parameter.strings[0]);
    if (found == textures.end()) {
        std::vector<std::string> names;
        for (const auto& row : textures) names.push_back(row.first);
        fail(parameter.values_place, "no texture is called \"" + parameter.strings[0] + "\"",
             suggestion(parameter.strings[0], names));
    }
    if (found->second.kind != "constant")
        fail(parameter.values_place,
             "texture \"" + found->first + "\" is of class \"" + found->second.kind +
                 "\", understood but not supported yet",
             "give a value in its place: \"rgb " + parameter.name + "\" [ r g b ]");
    return found->second;
}

double Parameters::number_of(const Parameter& parameter, bool infinite_allowed) {
    if (parameter.type == ParameterType::texture) {
        const Texture& constant = texture(parameter);
        if (!constant.is_float) wrong_type(parameter, "a float texture");
        return constant.value.x;
    }
    if (parameter.type != ParameterType::number && parameter.type != ParameterType::integer)
        wrong_type(parameter, "float");
    if (parameter.numbers.size() != 1)
        fail(parameter.place, "parameter \"" + parameter.name + "\" of " + title_ +
                                  " wants 1 number, has " +
                                  std::to_string(parameter.numbers.size()));
    if (!infinite_allowed && !std::isfinite(parameter.numbers[0]))
        fail(parameter.values_place,
             "parameter \"" + parameter.name + "\" of " + title_ + " wants a finite number");
    return parameter.numbers[0];
}

double Parameters::number(Names names, double fallback) {
    const Parameter* parameter = find(names);
    return parameter ? number_of(*parameter) : fallback;
}

int Parameters::integer(Names names, int fallback) {
    const Parameter* parameter = find(names);
    if (!parameter) return fallback;
    if (parameter->type != ParameterType::integer) wrong_type(*parameter, "integer");
    return static_cast<int>(number_of(*parameter));
}

bool Parameters::flag(Names names, bool fallback) {
    const Parameter* parameter = find(names);
    if (!parameter) return fallback;
    if (parameter->type != ParameterType::boolean || parameter->strings.size() != 1)
        wrong_type(*parameter, "one bool");
    return parameter->strings[0] == "true";
}

std::string Parameters::text(Names names, const std::string& fallback) {
    const Parameter* parameter = find(names);
    if (!parameter) return fallback;
    if (parameter->type != ParameterType::string || parameter->strings.size() != 1)
        wrong_type(*parameter, "one string");
    return parameter->strings[0];
}

glm::dvec3 Parameters::point(Names names, const glm::dvec3& fallback) {
    const Parameter* parameter =
        list(names, {ParameterType::point3, ParameterType::vector3, ParameterType::normal});
    if (!parameter) return fallback;
    if (parameter->numbers.size() != 3) wrong_type(*parameter, "one point");
    return {parameter->numbers[0], parameter->numbers[1], parameter->numbers[2]};
}

const Parameter* Parameters::list(Names names, std::initializer_list<ParameterType> types) {
    const Parameter* parameter = find(names);
    if (!parameter) return nullptr;
    if (std::find(types.begin(), types.end(), parameter->type) == types.end())
        wrong_type(*parameter, type_name(*types.begin()));
    return parameter;
}

glm::dvec3 Parameters::colour(Names names, const glm::dvec3& fallback, ColourUse use) {
    const Parameter* parameter = find(names);
    return parameter ? colour_of(*parameter, use) : fallback;
}

void Parameters::check_range(double value, double low, double high, const std::string& hint) const {
    if (value >= low && value <= high) return;
    const std::string name = last_ ? "parameter \"" + last_->name + "\" of " + title_ : title_;
    std::string wants = " wants a value from " + show(low) + " to " + show(high);
    if (std::isinf(high)) wants = " wants " + show(low) + " or more";
    fail(last_place(), name + wants + ", has " + show(value), hint);
}

void Parameters::check_range(const glm::dvec3& value, double low, double high,
                             const std::string& hint) const {
    for (int i = 0; i < 3; ++i) check_range(value[i], low, high, hint);
}

void Parameters::check_float(const glm::dvec3& value) const {
    for (int i = 0; i < 3; ++i)
        if (std::isfinite(value[i]) && std::fabs(value[i]) > std::numeric_limits<float>::max())
            fail(last_place(), "the value " + show(value[i]) + " of " + title_ + " is too large");
}

void Parameters::refuse(Names names, const std::string& hint) {
    if (const Parameter* parameter = find(names))
        fail(parameter->place,
             "parameter \"" + parameter->name + "\" of " + title_ +
                 " is understood but not supported yet",
             hint);
}

void Parameters::finish() {
    std::sort(known_.begin(), known_.end());
    known_.erase(std::unique(known_.begin(), known_.end()), known_.end());
    for (std::size_t i = 0; i < used_.size(); ++i) {
        if (used_[i]) continue;
        const Parameter& parameter = statement_.parameters[i];
        context_.fault(
            parameter.place, "unknown parameter \"" + parameter.name + "\" of " + title_,
            known_.empty() ? title_ + " has no parameters" : suggestion(parameter.name, known_));
    }
}

}  // namespace lobe
