// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_reader.h"

#include <algorithm>

#include "base/error.h"
#include "scene/camera_film.h"
#include "scene/dialect.h"
#include "scene/materials.h"

namespace lobe {

namespace {

constexpr std::size_t files_limit = 1000000;  // includes carried out, the same file counted again

}  // namespace

std::string resolve_path(const ReadContext& context, const std::string& name, const Place& place) {
    return resolve_path(name, place, context.folder);
}

const std::map<std::string, SceneReader::Row>& SceneReader::handlers() {
    using R = SceneReader;
    static const std::map<std::string, Row> table{
        {"Accelerator", {&R::ignored, Row::before_world}},
        {"ActiveTransform", {&R::active_transform, Row::anywhere}},
        {"AreaLightSource", {&R::area_light, Row::in_world}},
        {"Attribute", {&R::not_yet, Row::anywhere}},
        {"AttributeBegin", {&R::attribute_begin, Row::in_world}},
        {"AttributeEnd", {&R::attribute_end, Row::in_world}},
        {"Camera", {&R::camera, Row::before_world}},
        {"ColorSpace", {&R::color_space, Row::anywhere}},
        {"ConcatTransform", {&R::concat_transform, Row::anywhere}},
        {"CoordSysTransform", {&R::coord_sys_transform, Row::anywhere}},
        {"CoordinateSystem", {&R::coordinate_system, Row::anywhere}},
        {"Film", {&R::film, Row::before_world}},
        {"Identity", {&R::identity, Row::anywhere}},
        {"Integrator", {&R::integrator, Row::before_world}},
        {"LightSource", {&R::light, Row::in_world}},
        {"LookAt", {&R::look_at, Row::anywhere}},
        {"MakeNamedMaterial", {&R::make_named_material, Row::in_world}},
        {"MakeNamedMedium", {&R::not_yet, Row::anywhere}},
        {"Material", {&R::material, Row::in_world}},
        {"MediumInterface", {&R::medium_interface, Row::anywhere}},
        {"NamedMaterial", {&R::named_material, Row::in_world}},
        {"ObjectBegin", {&R::object_begin, Row::in_world}},
        {"ObjectEnd", {&R::object_end, Row::in_world}},
        {"ObjectInstance", {&R::object_instance, Row::in_world}},
        {"Option", {&R::option, Row::anywhere}},
        {"PixelFilter", {&R::pixel_filter, Row::before_world}},
        {"Renderer", {&R::not_yet, Row::before_world}},
        {"ReverseOrientation", {&R::reverse_orientation, Row::in_world}},
        {"Rotate", {&R::rotate, Row::anywhere}},
        {"Sampler", {&R::sampler, Row::before_world}},
        {"Scale", {&R::scale, Row::anywhere}},
        {"Shape", {&R::shape, Row::in_world}},
        {"SurfaceIntegrator", {&R::integrator, Row::before_world}},
        {"Texture", {&R::texture, Row::in_world}},
        {"Transform", {&R::set_transform, Row::anywhere}},
        {"TransformBegin", {&R::transform_begin, Row::in_world}},
        {"TransformEnd", {&R::transform_end, Row::in_world}},
        {"TransformTimes", {&R::transform_times, Row::before_world}},
        {"Translate", {&R::translate, Row::anywhere}},
        {"Volume", {&R::not_yet, Row::anywhere}},
        {"VolumeIntegrator", {&R::not_yet, Row::before_world}},
        {"WorldBegin", {&R::world_begin, Row::anywhere}},
        {"WorldEnd", {&R::world_end, Row::in_world}},
    };
    return table;
}

SceneReader::SceneReader(const std::string& path, const std::vector<BrdfTable>& models,
                         const ReadOptions& options)
    : context_{models, options, scene_, nullptr, folder_of(path)},
      files_(path, options.lenient, scene_.warnings) {
    scene_.path = path;
    scene_.dialect = options.dialect == Dialect::automatic ? find_dialect(files_) : options.dialect;
    for (const auto& file : files_.in_reading_order()) hash_.add(file->source->text);
    shapes_ = &scene_.shapes;
    state_.names = context_.names = std::make_shared<Names>();
}

Scene SceneReader::read() {
    set_defaults(scene_);
    run();
    check_end();
    drop_unused_materials();
    for (const UserModel& model : scene_.models) hash_.add(model.text);
    hash_.add(scene_.tables.data(), scene_.tables.size() * sizeof(float));
    drop_unused_models();
    check_replacements(context_);
    scene_.hash = hash_.hex();
    return std::move(scene_);
}

void SceneReader::run() {
    open_files_.push_back({&files_.root(), 0, 0, 0});
    while (!open_files_.empty()) {
        OpenFile& open = open_files_.back();
        if (open.next_statement == open.file->statements.size()) {
            leave_file();
            continue;
        }
        const Statement& statement = open.file->statements[open.next_statement++];
        if (statement.name == "Include" || statement.name == "Import") {
            enter_file(statement);
        } else {
            carry_out(statement);
        }
    }
}

void SceneReader::carry_out(const Statement& statement) {
    const Row& row = handlers().at(statement.name);
    check_order(statement, row);
    try {
        (this->*row.handler)(statement);
    } catch (const UnknownClass& unknown) {
        if (!context_.options.lenient) throw;
        scene_.warnings.push_back(unknown.where() + ": " + unknown.what() + " is left out");
    }
}

void SceneReader::check_order(const Statement& statement, const Row& row) {
    if (world_ended_)
        fail(statement.place, statement.title() + " after WorldEnd",
             "a file with several frames is not supported: split it");
    if (row.where == Row::before_world && in_world_)
        fail(statement.place, statement.title() + " after WorldBegin", "move it before WorldBegin");
    if (row.where == Row::in_world && !in_world_)
        fail(statement.place, statement.title() + " before WorldBegin", "move it after WorldBegin");
}

void SceneReader::enter_file(const Statement& statement) {
    OpenFile& open = open_files_.back();
    const ParsedFile* const file = open.file->includes[open.next_include++];
    std::vector<const ParsedFile*> chain;
    for (const OpenFile& parent : open_files_) chain.push_back(parent.file);
    chain.push_back(file);
    if (chain.size() > include_depth_limit)
        fail(statement.place, "includes nest deeper than " + std::to_string(include_depth_limit) +
                                  " files: " + show_chain(chain));
    if (++files_entered_ > files_limit)
        fail(statement.place, "more than " + std::to_string(files_limit) + " files included");
    if (statement.name == "Import") {
        if (!in_world_) fail(statement.place, "Import before WorldBegin", "use Include");
        begin(BlockKind::import, statement);
    }
    open_files_.push_back({file, 0, 0, statement.name == "Import" ? blocks_.size() : 0});
}

void SceneReader::leave_file() {
    const std::size_t blocks = open_files_.back().blocks;
    open_files_.pop_back();
    if (blocks == 0) return;
    if (blocks_.size() != blocks)
        fail(blocks_.back().place, "a block that does not end within its imported file");
    state_ = std::move(blocks_.back().saved);
    context_.names = state_.names;
    blocks_.pop_back();
}

void SceneReader::check_end() {
    const auto& starts = files_.root().source->line_starts;
    const Place end{files_.root().source.get(), files_.root().source->text.size()};
    if (!blocks_.empty())
        context_.fault(blocks_.back().place, "a block that does not end", "add its End directive");
    if (!in_world_)
        fail(end, "no WorldBegin in the scene (" + std::to_string(starts.size()) + " lines)",
             "shapes, materials and lights stand after WorldBegin");
    if (scene_.dialect == Dialect::v3 && !world_ended_)
        context_.fault(end, "no WorldEnd: the scene may be incomplete",
                       "end a pbrt-v3 scene with WorldEnd");
    if (!undefined_materials_.empty()) {
        const Word& name = undefined_materials_.begin()->second;
        std::vector<std::string> names;
        for (const auto& row : context_.names->materials)
            if (!undefined_materials_.count(row.second)) names.push_back(row.first);
        fail(name.place, "no material is called \"" + name.text + "\"",
             suggestion(name.text, names));
    }
}

// A material that no shape has would still cost its model a place in the kernel.
void SceneReader::drop_unused_materials() {
    constexpr std::uint32_t unused = 0xffffffffu;
    std::vector<std::uint32_t> place(scene_.materials.size(), unused);
    std::vector<Material> kept;
    for (Shape& shape : scene_.shapes) {
        std::uint32_t& to = place[shape.material];
        if (to == unused) {
            to = static_cast<std::uint32_t>(kept.size());
            kept.push_back(std::move(scene_.materials[shape.material]));
        }
        shape.material = to;
    }
    scene_.materials = std::move(kept);
}

void SceneReader::drop_unused_models() {
    const auto unused = [&](const UserModel& model) {
        return std::none_of(scene_.materials.begin(), scene_.materials.end(),
                            [&](const Material& m) { return m.brdf == model.table.name; });
    };
    auto& models = scene_.models;
    models.erase(std::remove_if(models.begin(), models.end(), unused), models.end());
}

Scene read_scene(const std::string& path, const std::vector<BrdfTable>& models,
                 const ReadOptions& options) {
    return SceneReader(path, models, options).read();
}

}  // namespace lobe
