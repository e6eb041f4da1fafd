// SPDX-License-Identifier: Apache-2.0
// Units: radiance in W/(m^2 sr), intensity in W/sr, irradiance in W/m^2, each as linear sRGB.
#include "scene/lights.h"

#include <algorithm>
#include <cmath>

#include "scene/parameters.h"
#include "scene/transform.h"

namespace lobe {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double inf = std::numeric_limits<double>::infinity();

glm::dvec3 scaled(Parameters& p, const char* name) {
    const glm::dvec3 colour = p.colour({name}, glm::dvec3(1), ColourUse::light);
    p.check_range(colour, 0, inf);
    const glm::dvec3 scale = p.colour({"scale"}, glm::dvec3(1));
    p.check_range(scale, 0, inf);
    p.check_float(colour * scale);
    return colour * scale;
}

// A positive number, or nothing: pbrt-v4 reads `power` and `illuminance` so.
std::optional<double> positive(Parameters& p, const char* name) {
    const double value = p.number({name}, -1);
    return value > 0 ? std::optional(value) : std::nullopt;
}

void read_point_light(Parameters& p, const glm::dmat4& to_world, Scene& scene) {
    glm::dvec3 intensity = scaled(p, "I");
    if (const auto power = positive(p, "power")) intensity *= *power / (4 * pi);
    const glm::dvec3 from = p.point({"from"}, glm::dvec3(0));
    scene.point_lights.push_back({transform_point(to_world, from), glm::vec3(intensity)});
}

void read_distant_light(Parameters& p, const glm::dmat4& to_world, Scene& scene) {
    glm::dvec3 irradiance = scaled(p, "L");
    if (const auto illuminance = positive(p, "illuminance")) irradiance *= *illuminance;
    const glm::dvec3 from = p.point({"from"}, glm::dvec3(0));
    const glm::dvec3 to = p.point({"to"}, glm::dvec3(0, 0, 1));
    const glm::dvec3 towards = transform_vector(to_world, from - to);
    if (!(glm::length(towards) > 0))
        fail(p.last_place(), "a distant light whose from and to are the same point");
    scene.distant_lights.push_back({glm::normalize(towards), glm::vec3(irradiance)});
}

void read_environment(Parameters& p, Scene& scene) {
    p.refuse({"mapname", "filename"}, "environment maps are not there yet: give L");
    p.refuse({"portal"});
    p.ignore({"samples", "nsamples"});
    glm::dvec3 radiance = scaled(p, "L");
    if (const auto illuminance = positive(p, "illuminance")) radiance *= *illuminance / pi;
    scene.environment = scene.environment.value_or(glm::vec3(0)) + glm::vec3(radiance);
}

double area_of(const Mesh& mesh, const glm::uvec3& f) {
    const auto& p = mesh.positions;
    return glm::length(glm::cross(p[f.y] - p[f.x], p[f.z] - p[f.x])) / 2;
}

// The area that one emitter of the shape has: pbrt-v4 makes a light of every triangle.
double emitter_area(const AreaLight& light, const Shape& shape) {
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry))
        return 4 * pi * sphere->radius * sphere->radius;
    const Mesh& mesh = std::get<Mesh>(shape.geometry);
    double least = inf, most = 0;
    for (const glm::uvec3& f : mesh.triangles) {
        least = std::min(least, area_of(mesh, f));
        most = std::max(most, area_of(mesh, f));
    }
    if (most - least > 1e-4 * most)
        fail(light.place,
             "\"power\" on a mesh of unequal triangles is understood but not supported yet",
             "pbrt-v4 gives every triangle this power: give the radiance \"L\" and \"scale\"");
    return most;
}

}  // namespace

AreaLight read_area_light(const Statement& statement, const ReadContext& context) {
    const Word& kind = statement.strings[0];
    if (kind.text != "diffuse" && kind.text != "area")
        fail_class(kind.place, "AreaLightSource", kind.text, {"area", "diffuse"}, {});
    Parameters p(statement, context);
    p.refuse({"filename"}, "emission textures are not there yet: give L");
    p.ignore({"samples", "nsamples"});
    AreaLight light;
    light.place = statement.place;
    light.radiance = scaled(p, "L");
    light.two_sided = p.flag({"twosided"}, false);
    light.power = positive(p, "power");
    p.finish();
    return light;
}

Emission emission_of(const AreaLight& light, const Shape& shape) {
    glm::dvec3 radiance = light.radiance;
    if (light.power) {
        const double area = emitter_area(light, shape);
        if (!(area > 0)) fail(light.place, "\"power\" on a shape without area");
        radiance *= *light.power / (pi * area * (light.two_sided ? 2 : 1));
    }
    return {glm::vec3(radiance), light.two_sided};
}

void read_light(const Statement& statement, const glm::dmat4& light_to_world,
                ReadContext& context) {
    const Word& kind = statement.strings[0];
    Parameters p(statement, context);
    if (kind.text == "point") {
        read_point_light(p, light_to_world, context.scene);
    } else if (kind.text == "distant") {
        read_distant_light(p, light_to_world, context.scene);
    } else if (kind.text == "infinite") {
        read_environment(p, context.scene);
    } else {
        fail_class(kind.place, "LightSource", kind.text, {"distant", "infinite", "point"},
                   {"goniometric", "projection", "spot"});
    }
    p.finish();
}

}  // namespace lobe
