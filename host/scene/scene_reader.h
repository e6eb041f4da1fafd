// SPDX-License-Identifier: Apache-2.0
// Carries out the directives of a scene, one after the other.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/sha256.h"
#include "scene/context.h"
#include "scene/lights.h"
#include "scene/scene_files.h"

namespace lobe {

// What AttributeBegin saves and AttributeEnd brings back. TransformBegin saves the transform only.
struct GraphicsState {
    glm::dmat4 transform{1.0};     // object to world, or world to camera before WorldBegin
    bool transform_active = true;  // ActiveTransform names the start of the shutter or both ends
    bool reverse_orientation = false;
    std::optional<std::uint32_t> material;
    std::optional<AreaLight> area_light;
    std::shared_ptr<Names> names;
};

class SceneReader {
  public:
    SceneReader(const std::string& path, const std::vector<BrdfTable>& models,
                const ReadOptions& options);

    Scene read();

  private:
    enum class BlockKind { attribute, transform, object, import };
    struct Block {
        BlockKind kind;
        Place place;  // of the directive that began it
        GraphicsState saved;
    };
    struct OpenFile {
        const ParsedFile* file;
        std::size_t next_statement, next_include;
        std::size_t blocks;  // open blocks when an Import began
    };
    using Handler = void (SceneReader::*)(const Statement&);
    struct Row {
        Handler handler;
        enum { anywhere, before_world, in_world } where;
    };
    static const std::map<std::string, Row>& handlers();

    // scene_reader.cpp: files and the order of directives
    void run();
    void carry_out(const Statement& statement);
    void check_order(const Statement& statement, const Row& row);
    void enter_file(const Statement& statement);
    void leave_file();
    void check_end();
    void drop_unused_materials();
    void drop_unused_models();

    // directives_transform.cpp
    void identity(const Statement&);
    void translate(const Statement&);
    void scale(const Statement&);
    void rotate(const Statement&);
    void look_at(const Statement&);
    void concat_transform(const Statement&);
    void set_transform(const Statement&);
    void coordinate_system(const Statement&);
    void coord_sys_transform(const Statement&);
    void active_transform(const Statement&);
    void transform_times(const Statement&);
    void apply(const Statement&, const glm::dmat4&);
    void replace(const Statement&, const glm::dmat4&);

    // directives_block.cpp
    void attribute_begin(const Statement&);
    void attribute_end(const Statement&);
    void transform_begin(const Statement&);
    void transform_end(const Statement&);
    void reverse_orientation(const Statement&);
    void object_begin(const Statement&);
    void object_end(const Statement&);
    void object_instance(const Statement&);
    void world_begin(const Statement&);
    void world_end(const Statement&);
    void begin(BlockKind, const Statement&);
    Block end(BlockKind, const Statement&);

    // directives_scene.cpp
    void camera(const Statement&);
    void film(const Statement&);
    void pixel_filter(const Statement&);
    void sampler(const Statement&);
    void integrator(const Statement&);
    void ignored(const Statement&);
    void option(const Statement&);
    void color_space(const Statement&);
    void not_yet(const Statement&);
    void medium_interface(const Statement&);
    void material(const Statement&);
    void make_named_material(const Statement&);
    void named_material(const Statement&);
    void texture(const Statement&);
    void area_light(const Statement&);
    void light(const Statement&);
    void shape(const Statement&);
    Material understand(const Statement&, const std::string& type, const Place&);
    Names& names_to_change();
    std::uint32_t add_material(Material);
    void add_shape(const Statement&, Shape);

    Scene scene_;
    Sha256 hash_;
    ReadContext context_;
    SceneFiles files_;
    std::vector<OpenFile> open_files_;
    std::vector<Block> blocks_;
    GraphicsState state_;
    std::map<std::string, glm::dmat4> coordinate_systems_;
    std::map<std::string, std::vector<Shape>> objects_;
    std::vector<Shape>* shapes_ = nullptr;  // where shapes go: the scene's or an object's
    std::optional<std::uint32_t> standard_material_;
    std::map<std::uint32_t, Word> undefined_materials_;  // named before they are made (version 4)
    bool in_world_ = false, world_ended_ = false;
    std::size_t files_entered_ = 0;
    std::size_t triangles_ = 0;  // of the scene's shapes
};

}  // namespace lobe
