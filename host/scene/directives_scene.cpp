// SPDX-License-Identifier: Apache-2.0
// Directives that describe the camera and the world.
#include "base/error.h"
#include "scene/camera_film.h"
#include "scene/materials.h"
#include "scene/scene_reader.h"
#include "scene/shapes.h"

namespace lobe {

namespace {

constexpr std::size_t triangles_limit = std::size_t(1) << 28;

}  // namespace

void SceneReader::camera(const Statement& s) {
    read_camera(s, state_.transform, context_);
    coordinate_systems_["camera"] = scene_.camera.camera_to_world;
}

void SceneReader::film(const Statement& s) { read_film(s, context_); }
void SceneReader::pixel_filter(const Statement& s) { read_filter(s, context_); }
void SceneReader::sampler(const Statement& s) { read_sampler(s, context_); }
void SceneReader::integrator(const Statement& s) { read_integrator(s, context_); }
void SceneReader::ignored(const Statement&) {}

void SceneReader::option(const Statement& s) { context_.warn(s.place, "Option is left out"); }

void SceneReader::color_space(const Statement& s) {
    const Word& name = s.strings[0];
    if (name.text == "srgb") return;
    for (const char* later : {"dci-p3", "rec2020", "aces2065-1"})
        if (name.text == later)
            fail(name.place, s.title() + " is understood but not supported yet", "use srgb");
    fail(name.place, "unknown " + s.title(), suggestion(name.text, {"srgb"}));
}

void SceneReader::not_yet(const Statement& s) {
    fail(s.place, s.title() + " is understood but not supported yet");
}

// Shapes without a medium on either side are what lobe renders.
void SceneReader::medium_interface(const Statement& s) {
    for (const Word& medium : s.strings)
        if (!medium.text.empty())
            fail(s.place, "MediumInterface is understood but not supported yet",
                 "lobe renders surfaces, not volumes");
}

Names& SceneReader::names_to_change() {
    // in version 3 names live as long as the attribute block; in version 4 for ever
    if (!context_.v4() && state_.names.use_count() > 2)  // ours and the context's
        context_.names = state_.names = std::make_shared<Names>(*state_.names);
    return *state_.names;
}

std::uint32_t SceneReader::add_material(Material material) {
    scene_.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

// With --lenient a material of unknown type is the standard one.
Material SceneReader::understand(const Statement& s, const std::string& type, const Place& place) {
    try {
        return read_material(s, type, place, context_);
    } catch (const UnknownClass& unknown) {
        if (!context_.options.lenient) throw;
        context_.warn(place, std::string(unknown.what()) + ": taken for matte");
        return standard_material(context_);
    }
}

void SceneReader::material(const Statement& s) {
    const Word& type = s.strings[0];
    state_.material = add_material(understand(s, type.text, type.place));
}

void SceneReader::make_named_material(const Statement& s) {
    const Word& name = s.strings[0];
    Parameters parameters(s, context_);
    const Parameter* given = parameters.find({"type"});
    const std::string type = parameters.text({"type"}, "");
    if (!given && !parameters.find({"brdf"}))
        fail(s.place, s.title() + " lacks its parameter \"type\"", "\"string type\" \"matte\"");
    Material material = understand(s, type, given ? given->values_place : s.place);
    Names& names = names_to_change();
    const auto old = names.materials.find(name.text);
    if (old == names.materials.end()) {
        names.materials[name.text] = add_material(std::move(material));
    } else if (undefined_materials_.erase(old->second)) {
        scene_.materials[old->second] = std::move(material);
    } else {
        if (context_.v4())
            context_.fault(name.place, "a material called \"" + name.text + "\" is there already",
                           "give each material its own name");
        old->second = add_material(std::move(material));
    }
}

void SceneReader::named_material(const Statement& s) {
    const Word& name = s.strings[0];
    const auto found = state_.names->materials.find(name.text);
    if (found != state_.names->materials.end()) {
        state_.material = found->second;
        return;
    }
    if (!context_.v4()) {
        std::vector<std::string> names;
        for (const auto& row : state_.names->materials) names.push_back(row.first);
        fail(name.place, "no material is called \"" + name.text + "\"",
             suggestion(name.text, names));
    }
    state_.material = add_material({});
    names_to_change().materials[name.text] = *state_.material;
    undefined_materials_[*state_.material] = name;
}

void SceneReader::texture(const Statement& s) {
    const Word &name = s.strings[0], &type = s.strings[1], &kind = s.strings[2];
    if (type.text != "float" && type.text != "spectrum" && type.text != "color")
        fail(type.place, "unknown texture type \"" + type.text + "\"",
             suggestion(type.text, {"color", "float", "spectrum"}));
    Texture texture{kind.text, glm::dvec3(1), type.text == "float", s.place};
    if (kind.text == "constant") {
        Parameters parameters(s, context_, "texture \"" + name.text + "\"");
        texture.value = texture.is_float ? glm::dvec3(parameters.number({"value"}, 1))
                                         : parameters.colour({"value"}, glm::dvec3(1));
        parameters.finish();
    }
    names_to_change().textures[name.text] = texture;
}

void SceneReader::area_light(const Statement& s) {
    state_.area_light = read_area_light(s, context_);
}

void SceneReader::light(const Statement& s) { read_light(s, state_.transform, context_); }

void SceneReader::shape(const Statement& s) {
    Shape shape = read_shape(s, state_.transform, state_.reverse_orientation, context_, hash_);
    if (state_.area_light) {
        if (shapes_ != &scene_.shapes)
            fail(s.place, "an area light on a shape of an object is not supported",
                 "place the shape without ObjectBegin");
        shape.emission = emission_of(*state_.area_light, shape);
    }
    if (!state_.material) {
        if (!standard_material_) standard_material_ = add_material(standard_material(context_));
        shape.material = *standard_material_;
    } else {
        shape.material = *state_.material;
    }
    if (shapes_ == &scene_.shapes) return add_shape(s, std::move(shape));
    shapes_->push_back(std::move(shape));
}

void SceneReader::add_shape(const Statement& s, Shape shape) {
    if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) triangles_ += mesh->triangles.size();
    if (triangles_ > triangles_limit)
        fail(s.place, "the scene has more than " + std::to_string(triangles_limit) + " triangles");
    scene_.shapes.push_back(std::move(shape));
}

}  // namespace lobe
