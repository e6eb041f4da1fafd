// SPDX-License-Identifier: Apache-2.0
// Transforms: each directive multiplies the current one from the right.
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "scene/scene_reader.h"
#include "scene/transform.h"

namespace lobe {

void SceneReader::replace(const Statement& statement, const glm::dmat4& m) {
    if (!state_.transform_active) return;
    const std::string fault = transform_fault(m);
    if (!fault.empty()) fail(statement.place, statement.name + ": " + fault);
    state_.transform = m;
}

void SceneReader::apply(const Statement& statement, const glm::dmat4& m) {
    const std::string fault = transform_fault(m);
    if (!fault.empty()) fail(statement.place, statement.name + ": " + fault);
    replace(statement, state_.transform * m);
}

void SceneReader::identity(const Statement& s) { replace(s, glm::dmat4(1)); }

void SceneReader::translate(const Statement& s) {
    apply(s, glm::translate(glm::dmat4(1), glm::dvec3(s.numbers[0], s.numbers[1], s.numbers[2])));
}

void SceneReader::scale(const Statement& s) {
    apply(s, glm::scale(glm::dmat4(1), glm::dvec3(s.numbers[0], s.numbers[1], s.numbers[2])));
}

void SceneReader::rotate(const Statement& s) {
    const glm::dvec3 axis(s.numbers[1], s.numbers[2], s.numbers[3]);
    if (axis == glm::dvec3(0)) fail(s.place, "Rotate: the axis has no length");
    apply(s, rotation(s.numbers[0], axis));
}

void SceneReader::look_at(const Statement& s) {
    const auto& n = s.numbers;
    const auto m = lobe::look_at({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
    if (!m)
        fail(s.place, "LookAt: the eye is at the target, or up points along the view",
             "LookAt eye_x eye_y eye_z target_x target_y target_z up_x up_y up_z");
    apply(s, *m);
}

void SceneReader::concat_transform(const Statement& s) {
    apply(s, glm::make_mat4(s.numbers.data()));
}

void SceneReader::set_transform(const Statement& s) {
    replace(s, glm::make_mat4(s.numbers.data()));
}

void SceneReader::coordinate_system(const Statement& s) {
    coordinate_systems_[s.strings[0].text] = state_.transform;
}

void SceneReader::coord_sys_transform(const Statement& s) {
    const Word& name = s.strings[0];
    const auto found = coordinate_systems_.find(name.text);
    if (found != coordinate_systems_.end()) return replace(s, found->second);
    std::vector<std::string> names;
    for (const auto& row : coordinate_systems_) names.push_back(row.first);
    fail(name.place, "no coordinate system is called \"" + name.text + "\"",
         suggestion(name.text, names));
}

void SceneReader::active_transform(const Statement& s) {
    const Word& which = s.strings[0];
    if (which.text != "All" && which.text != "StartTime" && which.text != "EndTime")
        fail(which.place, "unknown ActiveTransform '" + which.text + "'",
             suggestion(which.text, {"All", "EndTime", "StartTime"}));
    if (which.text == "EndTime")
        context_.warn(s.place, "motion is not supported yet: the start of the shutter is taken");
    state_.transform_active = which.text != "EndTime";
}

void SceneReader::transform_times(const Statement& s) {
    context_.warn(s.place, "motion is not supported yet: the start of the shutter is taken");
}

}  // namespace lobe
