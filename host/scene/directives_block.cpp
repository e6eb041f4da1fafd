// SPDX-License-Identifier: Apache-2.0
// Blocks that save and bring back state, and objects, whose instances are copies.
#include "scene/mesh.h"
#include "scene/scene_reader.h"
#include "scene/transform.h"

namespace lobe {

void SceneReader::begin(BlockKind kind, const Statement& s) {
    blocks_.push_back({kind, s.place, state_});
}

SceneReader::Block SceneReader::end(BlockKind kind, const Statement& s) {
    static const char* const names[] = {"AttributeBegin", "TransformBegin", "ObjectBegin",
                                        "Import"};
    if (blocks_.empty()) fail(s.place, s.name + " without " + names[static_cast<int>(kind)]);
    if (blocks_.back().kind != kind)
        fail(s.place, s.name + " ends a block that " +
                          names[static_cast<int>(blocks_.back().kind)] + " began at " +
                          to_string(blocks_.back().place));
    Block block = std::move(blocks_.back());
    blocks_.pop_back();
    return block;
}

void SceneReader::attribute_begin(const Statement& s) { begin(BlockKind::attribute, s); }

void SceneReader::attribute_end(const Statement& s) {
    state_ = end(BlockKind::attribute, s).saved;
    context_.names = state_.names;
}

void SceneReader::transform_begin(const Statement& s) { begin(BlockKind::transform, s); }

void SceneReader::transform_end(const Statement& s) {
    const Block block = end(BlockKind::transform, s);
    state_.transform = block.saved.transform;
    state_.transform_active = block.saved.transform_active;
}

void SceneReader::reverse_orientation(const Statement&) {
    state_.reverse_orientation = !state_.reverse_orientation;
}

void SceneReader::object_begin(const Statement& s) {
    if (shapes_ != &scene_.shapes) fail(s.place, "ObjectBegin within an object");
    const Word& name = s.strings[0];
    if (objects_.count(name.text))
        context_.fault(name.place, "an object called \"" + name.text + "\" is there already",
                       "give each object its own name");
    begin(BlockKind::object, s);
    objects_[name.text].clear();
    shapes_ = &objects_[name.text];
}

void SceneReader::object_end(const Statement& s) {
    state_ = end(BlockKind::object, s).saved;
    context_.names = state_.names;
    shapes_ = &scene_.shapes;
}

void SceneReader::object_instance(const Statement& s) {
    if (shapes_ != &scene_.shapes) fail(s.place, "ObjectInstance within an object");
    const Word& name = s.strings[0];
    const auto found = objects_.find(name.text);
    if (found == objects_.end()) {
        std::vector<std::string> names;
        for (const auto& row : objects_) names.push_back(row.first);
        fail(name.place, "no object is called \"" + name.text + "\"", suggestion(name.text, names));
    }
    for (const Shape& shape : found->second) {
        bool fits = true;
        Shape instance = moved(shape, state_.transform, fits);
        if (!fits)
            fail(s.place, "object \"" + name.text + "\" does not fit this transform: " +
                              "a sphere is stretched, or a vertex is not finite");
        add_shape(s, std::move(instance));
    }
}

void SceneReader::world_begin(const Statement& s) {
    if (in_world_) fail(s.place, "a second WorldBegin");
    in_world_ = true;
    state_.transform = glm::dmat4(1);
    state_.transform_active = true;
    coordinate_systems_["world"] = state_.transform;
}

void SceneReader::world_end(const Statement& s) {
    if (!blocks_.empty())
        context_.fault(s.place,
                       "WorldEnd within the block that began at " + to_string(blocks_.back().place),
                       "end the block first");
    blocks_.clear();
    world_ended_ = true;
}

}  // namespace lobe
