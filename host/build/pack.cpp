// SPDX-License-Identifier: Apache-2.0
#include "build/pack.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "base/error.h"
#include "base/luminance.h"
#include "build/feature_check.h"
#include "build/filter.h"

namespace lobe {
namespace {

// Fills the arrays of a PackedScene shape by shape.
class Packer {
  public:
    Packer(const Scene& scene, PackedScene& packed) : scene_(scene), packed_(packed) {}

    void pack() {
        pack_materials();
        for (const Shape& shape : scene_.shapes)
            if (std::holds_alternative<Mesh>(shape.geometry)) pack_mesh(shape);
        for (const Shape& shape : scene_.shapes)
            if (std::holds_alternative<Sphere>(shape.geometry)) pack_sphere(shape);
        pack_small_lights();
        packed_.lights = make_light_tree(lights_);
        if (packed_.lights.lights.empty())
            for (LobeSurface& surface : packed_.surfaces) surface.first_light = LOBE_NONE;
    }

  private:
    void pack_materials() {
        packed_.tables = scene_.tables;
        for (const Material& material : scene_.materials) {
            const auto& models = packed_.models;
            const auto model =
                std::find_if(models.begin(), models.end(),
                             [&](const auto& table) { return table.name == material.brdf; }) -
                models.begin();
            packed_.materials.push_back(
                {static_cast<LobeUint>(model), static_cast<LobeUint>(packed_.rows.size()), 0, 0});
            for (const auto& row : material.rows)
                packed_.rows.push_back({row[0], row[1], row[2], row[3]});
        }
    }

    LobeUint add_surface(const Shape& shape, std::size_t first_primitive, bool normals) {
        LobeSurface surface{};
        surface.material = shape.material;
        surface.first_light = shape.emission ? static_cast<LobeUint>(lights_.size()) : LOBE_NONE;
        surface.first_primitive = static_cast<LobeUint>(first_primitive);
        surface.flags =
            (normals ? LOBE_SURFACE_NORMALS : 0) | (shape.flipped ? LOBE_SURFACE_FLIPPED : 0);
        packed_.surfaces.push_back(surface);
        return static_cast<LobeUint>(packed_.surfaces.size() - 1);
    }

    void pack_mesh(const Shape& shape) {
        const Mesh& mesh = std::get<Mesh>(shape.geometry);
        auto& vertices = packed_.vertices;
        auto& triangles = packed_.triangles;
        if (vertices.size() + mesh.positions.size() >= LOBE_NONE ||
            triangles.size() + mesh.triangles.size() >= LOBE_NONE)
            throw Error(ExitCode::scene, "the scene has more than 2^32 vertices or triangles",
                        shape.where);
        const auto first = static_cast<LobeUint>(vertices.size());
        const LobeUint surface = add_surface(shape, triangles.size(), !mesh.normals.empty());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 p(packed_.placement.point(mesh.positions[i]));
            const glm::vec3 n = mesh.normals.empty() ? glm::vec3(0) : mesh.normals[i];
            const glm::vec2 uv = mesh.uvs.empty() ? glm::vec2(0) : mesh.uvs[i];
            vertices.push_back({p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y});
        }
        for (const glm::uvec3& t : mesh.triangles) {
            triangles.push_back({first + t.x, first + t.y, first + t.z, surface});
            if (shape.emission) add_triangle_light(shape);
        }
    }

    LobeLight area_light(const Shape& shape, LobeUint kind, std::size_t primitive) const {
        LobeLight light{};
        light.kind = kind;
        light.primitive = static_cast<LobeUint>(primitive);
        light.flags = (shape.emission->two_sided ? LOBE_LIGHT_TWO_SIDED : 0) |
                      (shape.flipped ? LOBE_LIGHT_FLIPPED : 0);
        light.r = shape.emission->radiance.x;
        light.g = shape.emission->radiance.y;
        light.b = shape.emission->radiance.z;
        return light;
    }

    // The light of the triangle added last; without area it has no intensity and is never chosen.
    void add_triangle_light(const Shape& shape) {
        const LobeTriangle& t = packed_.triangles.back();
        const auto corner = [&](LobeUint i) {
            const LobeVertex& v = packed_.vertices[i];
            return glm::dvec3(v.px, v.py, v.pz);
        };
        const glm::dvec3 a = corner(t.v0), b = corner(t.v1), c = corner(t.v2);
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const double area = glm::length(across) / 2;
        LobeLight light = area_light(shape, LOBE_LIGHT_TRIANGLE, packed_.triangles.size() - 1);
        light.area = static_cast<float>(area);
        LightBounds bounds;
        bounds.low = glm::min(a, glm::min(b, c));
        bounds.high = glm::max(a, glm::max(b, c));
        if (light.area > 0) {
            bounds.intensity = luminance(shape.emission->radiance) * area;
            bounds.axis = across * ((shape.flipped ? -0.5 : 0.5) / area);
        }
        if (shape.emission->two_sided) bounds.spread = glm::pi<double>();
        lights_.push_back({light, bounds, completes_quadrilateral(light, bounds.axis)});
    }

    // Whether the triangle added last and the one before it, a light of the same shape that begins
    // no other quadrilateral, lie in one plane and share an edge.
    bool completes_quadrilateral(const LobeLight& light, const glm::dvec3& axis) const {
        if (lights_.empty() || lights_.back().completes || !(light.area > 0)) return false;
        const LobeLight& before = lights_.back().light;
        const LobeTriangle& b = packed_.triangles.back();
        const LobeTriangle& a = *(packed_.triangles.end() - 2);
        if (before.kind != LOBE_LIGHT_TRIANGLE || before.primitive + 1 != light.primitive ||
            a.surface != b.surface || !(before.area > 0))
            return false;
        const LobeUint first[3] = {a.v0, a.v1, a.v2}, second[3] = {b.v0, b.v1, b.v2};
        int shared = 0;
        for (const LobeUint v : first) shared += std::count(second, second + 3, v);
        return shared == 2 && glm::dot(lights_.back().bounds.axis, axis) > 1 - 1e-10;
    }

    void pack_sphere(const Shape& shape) {
        const Sphere& sphere = std::get<Sphere>(shape.geometry);
        const glm::vec3 c(packed_.placement.point(sphere.centre));
        const auto radius = static_cast<float>(packed_.placement.length(sphere.radius));
        const std::size_t primitive = packed_.triangles.size() + packed_.spheres.size();
        const LobeUint surface = add_surface(shape, primitive, false);
        packed_.spheres.push_back({c.x, c.y, c.z, radius, surface, 0, 0, 0});
        if (!shape.emission) return;
        LobeLight light = area_light(shape, LOBE_LIGHT_SPHERE, primitive);
        light.x = c.x;
        light.y = c.y;
        light.z = c.z;
        light.radius = radius;
        light.area = static_cast<float>(4 * glm::pi<double>() * radius * radius);
        const double disk = glm::pi<double>() * radius * radius;
        lights_.push_back({light, shines_everywhere(glm::dvec3(c) - double(radius),
                                                    glm::dvec3(c) + double(radius),
                                                    disk * luminance(shape.emission->radiance))});
    }

    static LightBounds shines_everywhere(const glm::dvec3& low, const glm::dvec3& high,
                                         double intensity) {
        LightBounds bounds;
        bounds.low = low;
        bounds.high = high;
        bounds.intensity = intensity;
        bounds.spread = glm::pi<double>();
        return bounds;
    }

    void pack_small_lights() {
        const double scale = packed_.placement.scale;
        for (const PointLight& point : scene_.point_lights) {
            LobeLight light{};
            light.kind = LOBE_LIGHT_POINT;
            light.primitive = LOBE_NONE;
            const glm::vec3 intensity(glm::dvec3(point.intensity) * scale * scale);
            set_colour(light, intensity);
            const glm::dvec3 at = packed_.placement.point(point.position);
            set_vector(light, at);
            lights_.push_back({light, shines_everywhere(at, at, luminance(intensity))});
        }
        for (const DistantLight& distant : scene_.distant_lights) {
            LobeLight light{};
            light.kind = LOBE_LIGHT_DISTANT;
            light.primitive = LOBE_NONE;
            set_colour(light, distant.irradiance);
            set_vector(light, distant.towards);
            LightBounds bounds =
                shines_everywhere(distant.towards, distant.towards, luminance(distant.irradiance));
            bounds.distant = true;
            lights_.push_back({light, bounds});
        }
    }

    static void set_colour(LobeLight& light, const glm::vec3& c) {
        light.r = c.x;
        light.g = c.y;
        light.b = c.z;
    }
    static void set_vector(LobeLight& light, const glm::dvec3& v) {
        light.x = static_cast<float>(v.x);
        light.y = static_cast<float>(v.y);
        light.z = static_cast<float>(v.z);
    }

    const Scene& scene_;
    PackedScene& packed_;
    std::vector<BoundedLight> lights_;
};

void pack_filter_table(const FilterTable& table, LobeFrame& frame) {
    frame.filter_table = 1;
    frame.filter_negative_x = static_cast<float>(table.negative_x);
    frame.filter_negative_y = static_cast<float>(table.negative_y);
    frame.filter_weight = static_cast<float>(table.weight);
}

// The tables of the models that the scene uses.
std::vector<BrdfTable> tables_in_use(const Scene& scene, const std::vector<BrdfTable>& models) {
    std::vector<BrdfTable> used;
    for (const std::string& name : models_in_use(scene)) {
        const auto found = std::find_if(models.begin(), models.end(),
                                        [&](const BrdfTable& table) { return table.name == name; });
        if (found != models.end()) {
            used.push_back(*found);
        } else {
            used.emplace_back();
            used.back().name = name;
            used.back().file = "brdf/" + name + ".h";
        }
    }
    return used;
}

// A material of too few rows would have its model read those of the next one.
void check_rows(const Scene& scene, const std::vector<BrdfTable>& models) {
    for (const Material& material : scene.materials)
        for (const BrdfTable& table : models)
            if (table.name == material.brdf && table.parameters.size() != material.rows.size())
                throw Error(ExitCode::internal,
                            "a material of the model '" + table.name + "' has " +
                                std::to_string(material.rows.size()) + " parameters, not " +
                                std::to_string(table.parameters.size()),
                            material.where);
}

FeatureSet features_for(const Scene& scene, const PackOptions& options) {
    if (options.all_features) return all_features();
    FeatureSet features = derive_features(scene);
    for (const Feature feature : options.forced) force(features, feature);
    return features;
}

}  // namespace

KernelNeeds kernel_needs(const Scene& scene, const PackOptions& options) {
    const bool all_models = options.all_features || options.all_models;
    return {features_for(scene, options), options.integrator,
            all_models ? options.models : tables_in_use(scene, options.models)};
}

PackedScene pack_scene(const Scene& scene, const PackOptions& options) {
    check_rows(scene, options.models);
    PackedScene packed{kernel_needs(scene, options)};
    packed.placement = place_scene(scene);
    Packer(scene, packed).pack();
    packed.bvh = build_bvh(packed.triangles, packed.vertices, packed.spheres);
    packed.frame = pack_frame(scene, packed.placement);
    if (scene.filter.kind != FilterKind::box) {
        FilterTable table = tabulate_filter(scene.filter);
        pack_filter_table(table, packed.frame);
        packed.filter_nodes = std::move(table.nodes);
    }
    packed.frame.triangles = static_cast<LobeUint>(packed.triangles.size());
    packed.frame.lights = static_cast<LobeUint>(packed.lights.lights.size());
    packed.frame.light_root = packed.lights.root;
    check_features(packed);
    return packed;
}

void free_shapes(PackedScene& packed) {
    packed.bvh = {};
    packed.triangles = {};
    packed.vertices = {};
    packed.spheres = {};
    packed.surfaces = {};
    packed.tables = {};
    packed.lights = {};
}

}  // namespace lobe
