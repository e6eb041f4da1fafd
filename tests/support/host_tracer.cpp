// SPDX-License-Identifier: Apache-2.0
#include "support/host_tracer.h"

#include <cmath>

#include "support/meshes.h"
#include "support/film_blocks.h"

namespace lobe::test {

namespace {

using glm::dvec3;

constexpr double pi = 3.14159265358979323846;
constexpr double nudge = 1e-9;

struct Face {
    dvec3 a, e1, e2;
    const Shape* shape;
};

struct Met {
    double distance = 1e300;
    dvec3 point{0}, normal{0};  // normal on the side that shines
    const Shape* shape = nullptr;
};

class Tracer {
  public:
    Tracer(const Scene& scene, bool by_chance) : scene_(scene), by_chance_(by_chance) {
        for (const Shape& shape : scene.shapes) {
            if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
                for (const glm::uvec3& t : mesh->triangles) {
                    const dvec3 a = mesh->positions[t.x];
                    faces_.push_back(
                        {a, mesh->positions[t.y] - a, mesh->positions[t.z] - a, &shape});
                    if (shape.emission) shining_faces_.push_back(faces_.back());
                }
            } else {
                spheres_.push_back(&shape);
                if (shape.emission) shining_spheres_.push_back(&shape);
            }
        }
    }

    dvec3 radiance(dvec3 origin, dvec3 way, Random& random) const {
        dvec3 sum(0), weight(1);
        for (unsigned depth = 0;; ++depth) {
            const Met met = nearest(origin, way, 1e300);
            if (!met.shape) return sum + weight * dvec3(scene_.environment.value_or(glm::vec3(0)));
            if (by_chance_ || depth == 0) sum += weight * emitted(met, way);
            if (depth == scene_.max_depth) return sum;
            const dvec3 n = glm::dot(met.normal, way) < 0 ? met.normal : -met.normal;
            const auto& row = scene_.materials[met.shape->material].rows[0];
            const dvec3 f(row[0], row[1], row[2]);
            origin = met.point + nudge * n;
            sum += weight * f * direct(origin, n, random);
            weight *= pi * f;
            way = cosine_direction(n, random);
        }
    }

  private:
    Met nearest(const dvec3& o, const dvec3& d, double reach) const {
        Met met;
        met.distance = reach;
        for (const Face& face : faces_) {  // Moeller and Trumbore
            const dvec3 p = glm::cross(d, face.e2), s = o - face.a, q = glm::cross(s, face.e1);
            const double determinant = glm::dot(face.e1, p);
            const double u = glm::dot(s, p) / determinant, v = glm::dot(d, q) / determinant;
            const double t = glm::dot(face.e2, q) / determinant;
            if (!(u >= 0 && v >= 0 && u + v <= 1 && t > nudge && t < met.distance)) continue;
            met = {t, o + t * d, glm::normalize(glm::cross(face.e1, face.e2)), face.shape};
        }
        for (const Shape* shape : spheres_) {
            const auto& sphere = std::get<Sphere>(shape->geometry);
            const dvec3 f = o - sphere.centre;
            const double b = -glm::dot(f, d), across = glm::length(f + b * d);
            if (across > sphere.radius) continue;
            const double half = std::sqrt((sphere.radius - across) * (sphere.radius + across));
            const double t = b - half > nudge ? b - half : b + half;
            if (!(t > nudge && t < met.distance)) continue;
            met = {t, o + t * d, glm::normalize(f + t * d), shape};
        }
        if (met.shape && met.shape->flipped) met.normal = -met.normal;
        return met;
    }

    static dvec3 emitted(const Met& met, const dvec3& way) {
        if (!met.shape->emission) return dvec3(0);
        const bool seen = met.shape->emission->two_sided || glm::dot(met.normal, way) < 0;
        return seen ? dvec3(met.shape->emission->radiance) : dvec3(0);
    }

    // Irradiance of all that a path cannot find, or is not asked to find.
    dvec3 direct(const dvec3& point, const dvec3& n, Random& random) const {
        dvec3 sum(0);
        for (const PointLight& light : scene_.point_lights) {
            const dvec3 way = light.position - point;
            const double distance = glm::length(way), cosine = glm::dot(n, way) / distance;
            if (cosine > 0 && !nearest(point, way / distance, distance - nudge).shape)
                sum += dvec3(light.intensity) * cosine / (distance * distance);
        }
        for (const DistantLight& light : scene_.distant_lights) {
            const double cosine = glm::dot(n, light.towards);
            if (cosine > 0 && !nearest(point, light.towards, 1e300).shape)
                sum += dvec3(light.irradiance) * cosine;
        }
        const std::size_t lights = shining_faces_.size() + shining_spheres_.size();
        if (by_chance_ || lights == 0) return sum;
        const std::uint32_t chosen = random.below(unsigned(lights));
        Met on;
        double area = 0;
        if (chosen < shining_faces_.size()) {
            const Face& face = shining_faces_[chosen];
            const double root = std::sqrt(random.uniform()), v = random.uniform();
            const dvec3 across = glm::cross(face.e1, face.e2);
            on = {0, face.a + root * (1 - v) * face.e1 + root * v * face.e2, glm::normalize(across),
                  face.shape};
            area = glm::length(across) / 2;
        } else {
            const Shape* shape = shining_spheres_[chosen - shining_faces_.size()];
            const auto& sphere = std::get<Sphere>(shape->geometry);
            const dvec3 out = random_direction(random);
            on = {0, sphere.centre + sphere.radius * out, out, shape};
            area = 4 * pi * sphere.radius * sphere.radius;
        }
        if (on.shape->flipped) on.normal = -on.normal;
        const dvec3 way = on.point - point;
        const double distance = glm::length(way);
        const dvec3 d = way / distance;
        const double cosine = glm::dot(n, d), other = std::abs(glm::dot(on.normal, d));
        if (cosine <= 0 || nearest(point, d, distance * (1 - 1e-9)).shape) return sum;
        return sum +
               emitted(on, d) * (cosine * other / (distance * distance) * area * double(lights));
    }

    static dvec3 cosine_direction(const dvec3& n, Random& random) {
        return glm::normalize(n + (1 - 1e-9) * random_direction(random));
    }

    const Scene& scene_;
    bool by_chance_;
    std::vector<Face> faces_, shining_faces_;
    std::vector<const Shape*> spheres_, shining_spheres_;
};

// Pinhole or thin lens, box filter of half a pixel.
dvec3 camera_sample(const Scene& scene, const Tracer& tracer, double x, double y, Random& random) {
    const double size = scene.film.width, t = std::tan(scene.camera.fov * pi / 360);
    const dvec3 local((2 * x / size - 1) * t, (1 - 2 * y / size) * t, 1);
    const double angle = random.uniform(0, 2 * pi);
    const double r = scene.camera.lens_radius * std::sqrt(random.uniform());
    const dvec3 lens(r * std::cos(angle), r * std::sin(angle), 0);
    const dvec3 way = r > 0 ? scene.camera.focal_distance * local - lens : local;
    const glm::dmat4& m = scene.camera.camera_to_world;
    return tracer.radiance(dvec3(m * glm::dvec4(lens, 1)),
                           glm::normalize(dvec3(m * glm::dvec4(way, 0))), random);
}

}  // namespace

Picture trace_on_host(const Scene& scene, std::uint32_t samples, std::uint64_t seed,
                      bool by_chance) {
    const Tracer tracer(scene, by_chance);
    Picture picture{Film(scene.film.width, scene.film.height), {}, {}, ""};
    const std::size_t pixels = picture.film.pixels();
    Random random(seed);
    for (std::uint32_t first = 0; first < samples; first += LOBE_BLOCK) {
        std::vector<LobeBlockSum> sums(pixels * LOBE_REPLICATES);
        for (std::size_t p = 0; p < pixels; ++p)
            for (std::uint32_t s = 0; s < LOBE_BLOCK; ++s) {
                const double x = double(p % scene.film.width) + random.uniform();
                const double y = double(p / scene.film.width) + random.uniform();
                const dvec3 c = camera_sample(scene, tracer, x, y, random);
                LobeBlockSum& sum = sums[p * LOBE_REPLICATES + s % LOBE_REPLICATES];
                sum.r += float(c.x);
                sum.g += float(c.y);
                sum.b += float(c.z);
            }
        add_block(picture.film, sums, LOBE_BLOCK);
    }
    return picture;
}

}  // namespace lobe::test
