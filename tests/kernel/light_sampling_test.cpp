// SPDX-License-Identifier: Apache-2.0
// Sampling lights: directions that meet them, densities that are what they say, for samples and for
// rays that find a light by chance.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/chi_square.h"
#include "support/meshes.h"
#include "support/oracle.h"
#include "support/scenes.h"
#include "support/trace_rig.h"

using namespace lobe;
using namespace lobe::test;

namespace {

struct Trip {
    glm::vec3 towards;
    float distance, radiance, pdf, hit_pdf, hit_radiance;
};

struct From {
    glm::vec3 point;
    float choice, u, v;
    glm::vec3 normal{0, 0, 1};
};

class LightRig {
  public:
    explicit LightRig(const Scene& scene) : packed_(pack_scene(scene)) {}
    const PackedScene& packed() const { return packed_; }
    glm::vec3 place(const glm::dvec3& world) const {
        return glm::vec3(packed_.placement.point(world));
    }

    std::vector<Trip> trips(const std::vector<From>& from, std::uint32_t on = LOBE_NONE) const {
        const Device& d = test_device();
        std::vector<float> in;
        for (const From& f : from)
            in.insert(in.end(), {f.point.x, f.point.y, f.point.z, f.normal.x, f.normal.y,
                                 f.normal.z, f.choice, f.u, f.v});
        Buffer<float> out(d, 8 * from.size());
        const Program program =
            build_probe("probe/light.cl", {{"lobe_scene.h", scene_header(all_features(), {})}});
        run_probe(program, "light_round_trip", from.size(), Buffer<LobeNode>(d, packed_.bvh.nodes),
                  Buffer<LobeTriangleLeaf>(d, packed_.bvh.triangle_leaves),
                  Buffer<LobeSphereLeaf>(d, packed_.bvh.sphere_leaves),
                  Buffer<LobeTriangle>(d, packed_.triangles),
                  Buffer<LobeVertex>(d, packed_.vertices), Buffer<LobeSphere>(d, packed_.spheres),
                  Buffer<LobeSurface>(d, packed_.surfaces),
                  static_cast<cl_uint>(packed_.triangles.size()),
                  Buffer<LobeLight>(d, packed_.lights.lights),
                  Buffer<LobeLightNode>(d, packed_.lights.nodes),
                  static_cast<cl_uint>(packed_.lights.lights.size()),
                  static_cast<cl_uint>(packed_.lights.root), static_cast<cl_uint>(on),
                  Buffer<float>(d, in), out);
        const std::vector<float> n = out.read_all();
        std::vector<Trip> trips;
        for (std::size_t i = 0; i < n.size(); i += 8)
            trips.push_back(
                {{n[i], n[i + 1], n[i + 2]}, n[i + 3], n[i + 4], n[i + 5], n[i + 6], n[i + 7]});
        return trips;
    }

  private:
    PackedScene packed_;
};

constexpr int count = 1 << 16;

std::vector<From> from_one(const glm::vec3& point, std::uint64_t seed) {
    Random random(seed);
    std::vector<From> all;
    for (int i = 0; i < count; ++i)
        all.push_back(
            {point, random.uniform_float(), random.uniform_float(), random.uniform_float()});
    return all;
}

// E[1 / pdf] over samples that have one is the solid angle of what is sampled.
testing::AssertionResult solid_angle_is(const std::vector<Trip>& trips, double exact,
                                        double tests) {
    double sum = 0, squares = 0;
    for (const Trip& t : trips) {
        const double value = t.pdf > 0 ? 1 / double(t.pdf) : 0;
        sum += value;
        squares += value * value;
    }
    const double n = double(trips.size()), mean = sum / n;
    const double error = std::sqrt(std::max(0.0, squares / n - mean * mean) / n);
    return normal_deviate((mean - exact) / std::hypot(error, 1e-6 * exact), tests)
           << ", solid angle " << mean << " +- " << error << ", exactly " << exact;
}

}  // namespace

TEST(LightSampling, SphereConesOfAllWidths) {
    std::uint64_t seed = 10;
    for (const double angle :
         {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 1.0, 1.3962634}) {  // to 80 deg
        Scene scene = small_scene(0.5);
        const double radius = std::sin(angle);
        shine(add(scene, {0.3, -0.4, 1.2}, radius), 2);
        const LightRig rig(scene);
        const glm::dvec3 aside = glm::normalize(glm::dvec3(0.7, 0.6, -0.4));
        const glm::vec3 point = rig.place(glm::dvec3(0.3, -0.4, 1.2) + aside);
        const LobeSphere& s = rig.packed().spheres[0];
        const vec3l to_centre = vec3l(s.x, s.y, s.z) - vec3l(point);
        const Long d = glm::length(to_centre), sine = s.radius / d;
        const Long cone = sine * sine / (1 + std::sqrt(1 - sine * sine));
        const auto trips = rig.trips(from_one(point, ++seed));
        std::vector<double> cells(16 * 16);
        // An axis across the cone to measure azimuths from.
        const vec3l axis = to_centre / d, x = glm::normalize(glm::cross(axis, vec3l(0.1, 1, 0.3)));
        const vec3l y = glm::cross(axis, x);
        int outside = 0, off = 0, found = 0;
        for (const Trip& t : trips) {
            const vec3l w = glm::normalize(vec3l(t.towards));
            const Long gap = glm::length(w - axis), v = gap * gap / 2 / cone;
            outside += gap > 2 * std::asin(sine) * (1 + 1e-5L) / 2 + 3e-7L;
            ASSERT_NEAR(t.pdf, double(1 / (2 * pi * cone)), 2e-5 * t.pdf) << "angle " << angle;
            EXPECT_EQ(t.radiance, 2);
            off += Long(t.distance) > d + 3e-7L;  // the far side
            off +=
                std::fabs(glm::length(vec3l(point) + Long(t.distance) * w - vec3l(s.x, s.y, s.z)) -
                          s.radius) > 4e-7L + 1e-3L * s.radius * (v > 0.99L);
            if (t.hit_pdf >= 0) {
                ++found;
                ASSERT_NEAR(t.hit_pdf, t.pdf, 1e-5 * t.pdf);
                // At the rim rounding may turn the normal of a sphere that looks tiny.
                if (v < 0.99L && angle >= 1e-4) {
                    ASSERT_EQ(t.hit_radiance, 2);
                }
            }
            const Long turns = std::atan2(glm::dot(w, y), glm::dot(w, x)) / (2 * pi) + 0.5L;
            const int row = std::min(15, int(16 * v)), column = std::min(15, int(16 * turns));
            ++cells[16 * row + column];
        }
        EXPECT_EQ(outside, 0) << "angle " << angle;
        EXPECT_EQ(off, 0) << "angle " << angle;
        EXPECT_TRUE(solid_angle_is(trips, double(2 * pi * cone), 30)) << "angle " << angle;
        if (angle < 1e-3) continue;  // rounded directions are coarser than the cells, or miss
        EXPECT_GT(found, angle < 1e-2 ? count * 0.999 : count * 0.9999) << "angle " << angle;
        EXPECT_TRUE(follows(cells, std::vector<double>(cells.size(), 1), 30)) << "angle " << angle;
    }
}

TEST(LightSampling, SpheresFromInside) {
    Scene scene = small_scene(0.5);
    shine(add(scene, {0.1, 0.2, 0.3}, 2), 3).flipped = true;
    const LightRig rig(scene);
    for (const glm::dvec3& at :
         {glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(1, 1, 0), glm::dvec3(2, 0, 0)}) {
        const auto trips = rig.trips(from_one(rig.place(at), 3));
        int found = 0;
        for (const Trip& t : trips) {
            ASSERT_NEAR(t.pdf, 1 / (4 * double(pi)), 1e-6);
            found += t.hit_pdf == t.pdf && t.hit_radiance == 3;
        }
        EXPECT_EQ(found, count);
    }
    // From outside its inner light is not seen.
    for (const Trip& t : rig.trips(from_one(rig.place({4, 0, 0}), 4))) ASSERT_EQ(t.pdf, 0);
}

// On the shining sphere itself rounding must not decide which of the two samplers is meant.
TEST(LightSampling, SpheresFromTheirOwnSurface) {
    for (const bool two_sided : {false, true}) {
        Scene scene = small_scene(0.5);
        shine(add(scene, {0.1, 0.2, 0.3}, 2), 3, two_sided).flipped = true;
        const LightRig rig(scene);
        Random random(6);
        std::vector<From> from = from_one({}, 5);
        for (From& f : from)
            f.point = rig.place(glm::dvec3(0.1, 0.2, 0.3) + 2.0 * random_direction(random));
        const auto trips = rig.trips(from, 0);
        for (const Trip& t : trips) {
            if (t.pdf == 0) continue;
            ASSERT_NEAR(t.pdf, 1 / (4 * double(pi)), 1e-6);
            // The very tangent apart, what is sampled is met, with the density it was sampled with.
            if (t.distance > 1e-3) {
                ASSERT_EQ(t.hit_pdf, t.pdf);
            }
        }
        EXPECT_TRUE(solid_angle_is(trips, 2 * double(pi), 30));
    }
}

TEST(LightSampling, TrianglesByTheirSolidAngle) {
    Random random(8);
    for (int i = 0; i < 12; ++i) {
        Scene scene = small_scene(0.5);
        Mesh mesh;
        for (int k = 0; k < 3; ++k)
            mesh.positions.push_back(random_point(random) * (i % 3 == 0 ? 0.05 : 1.0));
        if (i == 1)
            mesh.positions[2] =
                0.5 * (mesh.positions[0] + mesh.positions[1]) + glm::dvec3(0, 1e-4, 0);
        mesh.triangles = {{0, 1, 2}};
        shine(add(scene, mesh), 4, true);
        const LightRig rig(scene);
        const glm::vec3 point = rig.place(glm::dvec3(1.5, -1.2, 0.9) + random_point(random));
        vec3l c[3];
        for (int k = 0; k < 3; ++k) {
            const LobeVertex& v = rig.packed().vertices[k];
            c[k] = glm::normalize(vec3l(v.px, v.py, v.pz) - vec3l(point));
        }
        // Van Oosterom and Strackee, 1983.
        const Long exact =
            2 * std::atan2(std::fabs(glm::dot(c[0], glm::cross(c[1], c[2]))),
                           1 + glm::dot(c[0], c[1]) + glm::dot(c[1], c[2]) + glm::dot(c[2], c[0]));
        const auto trips = rig.trips(from_one(point, 100 + i));
        int found = 0;
        for (const Trip& t : trips) {
            if (t.hit_pdf < 0) continue;
            ++found;
            ASSERT_NEAR(t.hit_pdf, t.pdf, 2e-4 * t.pdf);
            ASSERT_EQ(t.hit_radiance, 4);
        }
        EXPECT_GT(found, i == 1 ? count * 0.9 : count * 0.999) << "triangle " << i;
        EXPECT_TRUE(solid_angle_is(trips, double(exact), 30)) << "triangle " << i;
    }
}

// One-sided triangles shine where their normal points, flipped ones on the other side.
TEST(LightSampling, TrianglesShineOnOneSide) {
    for (const bool flipped : {false, true}) {
        Scene scene = small_scene(0.5);
        shine(add(scene, wall(5, 1)), 4).flipped = flipped;  // its normal points to -z
        const LightRig rig(scene);
        for (const double z : {4.0, 6.0}) {
            const bool lit = (z < 5) != flipped;
            for (const Trip& t : rig.trips(from_one(rig.place({0.1, 0.2, z}), 9))) {
                ASSERT_EQ(t.pdf > 0, lit);
                if (t.hit_pdf >= 0) {
                    ASSERT_EQ(t.hit_radiance, lit ? 4 : 0);
                }
            }
        }
    }
}
