// SPDX-License-Identifier: Apache-2.0
// Typed access to a directive's parameters. What is asked for is known; the rest is an error.
#pragma once

#include <initializer_list>
#include <optional>

#include "scene/context.h"
#include "scene/syntax.h"

namespace lobe {

// How a spectrum becomes a colour: a light's is brought to luminance one in version 4.
enum class ColourUse { plain, light };

class Parameters {
  public:
    // `title` is how messages name the owner; it is the statement's own title if empty.
    Parameters(const Statement& statement, const ReadContext& context, std::string title = "");

    // One value, or the fallback where the file has none of the names.
    using Names = std::initializer_list<const char*>;
    double number(Names names, double fallback);
    int integer(Names names, int fallback);
    bool flag(Names names, bool fallback);
    std::string text(Names names, const std::string& fallback);
    glm::dvec3 point(Names names, const glm::dvec3& fallback);
    glm::dvec3 colour(Names names, const glm::dvec3& fallback, ColourUse use = ColourUse::plain);

    // All values of a list whose type is one of `types`, or null. The first name found counts.
    const Parameter* list(Names names, std::initializer_list<ParameterType> types);

    // A number or colour of any of the types that can be one, textures included; null if absent.
    const Parameter* find(Names names);
    glm::dvec3 colour_of(const Parameter& parameter, ColourUse use = ColourUse::plain);
    double number_of(const Parameter& parameter, bool infinite_allowed = false);

    // Fails unless low <= value <= high, at the parameter found last.
    void check_range(double value, double low, double high, const std::string& hint = "") const;
    void check_range(const glm::dvec3& value, double low, double high,
                     const std::string& hint = "") const;

    // Fails for a value that the renderer's floats cannot hold.
    void check_float(const glm::dvec3& value) const;

    // "understood but not supported yet", if the parameter is there.
    void refuse(Names names, const std::string& hint = "");
    // Parameters that change nothing here.
    void ignore(Names names) { find(names); }
    // Fails for each parameter that was not asked for.
    void finish();

    const Place& place() const { return statement_.place; }
    // Of the parameter found last, else of the directive.
    Place last_place() const { return last_ ? last_->place : statement_.place; }
    const std::string& title() const { return title_; }

  private:
    [[noreturn]] void wrong_type(const Parameter& parameter, const std::string& wanted) const;
    const Texture& texture(const Parameter& parameter) const;

    const Statement& statement_;
    const ReadContext& context_;
    std::string title_;
    std::vector<bool> used_;
    std::vector<std::string> known_;
    const Parameter* last_ = nullptr;
};

}  // namespace lobe
