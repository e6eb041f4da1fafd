// SPDX-License-Identifier: Apache-2.0
// A scene as plain data, in world space and in double: what the reader gives and the builder takes.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/user_model.h"

namespace lobe {

struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;  // unit, one a position, or empty
    std::vector<glm::vec2> uvs;      // one a position, or empty
    std::vector<glm::uvec3> triangles;
};

struct Sphere {
    glm::dvec3 centre;
    double radius;
};

struct Emission {
    glm::vec3 radiance;
    bool two_sided = false;
};

// One shape of the scene file. The geometric normal of a triangle is cross(p1 - p0, p2 - p0) of its
// world positions, that of a sphere points outwards; `flipped` turns it round (the reader combines
// ReverseOrientation, the transform's handedness and given normals). Light leaves on its side.
struct Shape {
    std::variant<Mesh, Sphere> geometry;
    std::uint32_t material = 0;  // into Scene::materials
    std::optional<Emission> emission;
    bool flipped = false;
    std::string where;  // FILE:LINE:COL of its directive
};

// A reflectance model with its parameters, rows in the order of the model's table.
struct Material {
    std::string brdf;  // "rational"
    std::vector<std::array<float, 4>> rows;
    std::string type;   // as the scene file called it: "plastic"
    std::string where;  // FILE:LINE:COL
};

struct PointLight {
    glm::dvec3 position;
    glm::vec3 intensity;  // W/sr
};

struct DistantLight {
    glm::dvec3 towards;  // unit vector from the scene to the light
    glm::vec3 irradiance;
};

// Perspective. Camera space is pbrt's: x right, y up, z forward, left-handed.
struct Camera {
    glm::dmat4 camera_to_world{1.0};
    double fov = 90;         // degrees, across the shorter side of the film
    double lens_radius = 0;  // world units of camera space
    double focal_distance = 1e6;
    // left, right, bottom, top on the plane z = 1 / tan(fov / 2); absent: fits the film's aspect
    std::optional<std::array<double, 4>> screen_window;
};

struct FilmSettings {
    std::uint32_t width = 1280, height = 720;
    std::array<double, 4> crop{0, 1, 0, 1};  // x0, x1, y0, y1 as fractions
    std::string filename;                    // what the scene file asks for, or empty
};

enum class FilterKind { box, triangle, gaussian, mitchell };

struct Filter {
    FilterKind kind = FilterKind::box;
    double radius_x = 0.5, radius_y = 0.5;  // half widths in pixels
    double alpha = 2;                       // gaussian exp(-alpha x^2)
    double b = 1.0 / 3, c = 1.0 / 3;        // mitchell
};

enum class Dialect { automatic, v3, v4 };

struct Scene {
    std::string path;
    Dialect dialect = Dialect::automatic;  // never automatic once read
    Camera camera;
    FilmSettings film;
    Filter filter;
    std::uint32_t samples_per_pixel = 16;
    std::uint32_t max_depth = 5;  // scattering events of a path
    std::vector<Material> materials;
    std::vector<UserModel> models;  // those whose files the scene itself names
    std::vector<float> tables;  // measured reflectance; a `table` row holds an index as its bits
    std::map<std::string, std::uint32_t> table_places;  // where each file's table begins
    std::vector<Shape> shapes;
    std::vector<PointLight> point_lights;
    std::vector<DistantLight> distant_lights;
    std::optional<glm::vec3> environment;  // constant radiance from all around
    std::vector<std::string> warnings;
    std::string hash;  // SHA-256 of the text of all files read, in order of reading
};

}  // namespace lobe
