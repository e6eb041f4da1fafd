// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/error.h"
#include "build/pack.h"

namespace lobe {
namespace {

void store(const glm::dvec3& v, float& x, float& y, float& z) {
    x = static_cast<float>(v.x);
    y = static_cast<float>(v.y);
    z = static_cast<float>(v.z);
}

// pbrt's rule: the pixels whose corner lies in the crop window, rounded up at both ends.
void pack_film(const FilmSettings& film, LobeFrame& frame) {
    if (static_cast<std::uint64_t>(film.width) * film.height > 0xffffffffull)
        throw Error(ExitCode::scene, "the film has more than 2^32 pixels", "",
                    "choose a smaller --resolution");
    const auto corner = [](double fraction, std::uint32_t size) {
        // In float, as pbrt does: 0.07 of 100 pixels is 7, not a rounding above it.
        const auto part = static_cast<float>(std::clamp(fraction, 0.0, 1.0));
        return static_cast<std::uint32_t>(std::ceil(part * static_cast<float>(size)));
    };
    frame.film_width = film.width;
    frame.film_height = film.height;
    frame.window_x = corner(film.crop[0], film.width);
    frame.window_y = corner(film.crop[2], film.height);
    const std::uint32_t x1 = corner(film.crop[1], film.width);
    const std::uint32_t y1 = corner(film.crop[3], film.height);
    if (x1 <= frame.window_x || y1 <= frame.window_y)
        throw Error(ExitCode::scene, "the crop window holds no pixel");
    frame.window_width = x1 - frame.window_x;
    frame.tiles_across = (frame.window_width + LOBE_TILE - 1) / LOBE_TILE;
    frame.window_height = y1 - frame.window_y;
}

// The screen in camera space: the shorter side spans [-1, 1] on the plane at 1 / tan(fov / 2).
std::array<double, 4> screen_of(const Scene& scene) {
    if (scene.camera.screen_window) return *scene.camera.screen_window;
    const double aspect = static_cast<double>(scene.film.width) / scene.film.height;
    if (aspect > 1) return {-aspect, aspect, -1, 1};
    return {-1, 1, -1 / aspect, 1 / aspect};
}

void pack_camera(const Scene& scene, const Placement& placement, LobeFrame& frame) {
    const glm::dmat4& to_world = scene.camera.camera_to_world;
    const glm::dmat3 turn(to_world);
    const double unit = glm::length(turn[2]);  // world length of a camera unit
    const auto [left, right, bottom, top] = screen_of(scene);
    const double plane = 1 / std::tan(scene.camera.fov * glm::pi<double>() / 360);
    const glm::dvec3 corner = turn * glm::dvec3(left, top, plane) / (unit * plane);
    const glm::dvec3 dx =
        turn * glm::dvec3((right - left) / scene.film.width, 0, 0) / (unit * plane);
    const glm::dvec3 dy =
        turn * glm::dvec3(0, (bottom - top) / scene.film.height, 0) / (unit * plane);
    store(placement.point(glm::dvec3(to_world[3])), frame.eye_x, frame.eye_y, frame.eye_z);
    store(corner, frame.corner_x, frame.corner_y, frame.corner_z);
    store(dx, frame.dx_x, frame.dx_y, frame.dx_z);
    store(dy, frame.dy_x, frame.dy_y, frame.dy_z);
    store(turn[2] / unit, frame.axis_x, frame.axis_y, frame.axis_z);
    frame.lens_radius = static_cast<float>(placement.length(scene.camera.lens_radius * unit));
    frame.focal_distance = static_cast<float>(placement.length(scene.camera.focal_distance * unit));
}

}  // namespace

LobeFrame pack_frame(const Scene& scene, const Placement& placement) {
    LobeFrame frame{};
    pack_film(scene.film, frame);
    pack_camera(scene, placement, frame);
    frame.filter_radius_x = static_cast<float>(scene.filter.radius_x);
    frame.filter_radius_y = static_cast<float>(scene.filter.radius_y);
    frame.max_depth = scene.max_depth;
    const glm::vec3 environment = scene.environment.value_or(glm::vec3(0));
    store(glm::dvec3(environment), frame.environment_r, frame.environment_g, frame.environment_b);
    return frame;
}

}  // namespace lobe
