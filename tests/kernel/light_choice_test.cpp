// SPDX-License-Identifier: Apache-2.0
// Choosing among many lights: each that could bring light has a chance, and exactly the one told.
#include <gtest/gtest.h>

#include <cmath>

#include "support/chi_square.h"
#include "support/meshes.h"
#include "support/scenes.h"
#include "support/trace_rig.h"

using namespace lobe;
using namespace lobe::test;

namespace {

constexpr int samples = 1 << 16;

// Lights of all kinds, near and far, large and small, bright and dim.
Scene many_lights(int count, std::uint64_t seed) {
    Random random(seed);
    Scene scene = small_scene(0.5);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 at = 2.0 * random_point(random);
        const double size = random.log_uniform(1e-3, 0.5);
        const float brightness = float(random.log_uniform(0.01, 10));
        const int kind = i % 6;
        if (kind <= 2) {
            const Mesh quad =
                rectangle(at, size * random_direction(random), size * random_direction(random));
            shine(add(scene, quad), brightness, kind == 1).flipped = kind == 2;
        } else if (kind == 3) {
            shine(add(scene, at, 0.3 * size), brightness);
        } else if (kind == 4) {
            scene.point_lights.push_back({at, glm::vec3(brightness * float(size * size))});
        } else if (i % 30 == 5) {
            scene.distant_lights.push_back(
                {random_direction(random), glm::vec3(0.1f * brightness)});
        }
    }
    return scene;
}

glm::vec3 place(const PackedScene& packed, const glm::dvec3& world) {
    return glm::vec3(packed.placement.point(world));
}

struct Receivers {
    std::vector<glm::vec3> points, normals;
};

Receivers random_receivers(const PackedScene& packed, int count, std::uint64_t seed) {
    Random random(seed);
    Receivers all;
    for (int i = 0; i < count; ++i) {
        all.points.push_back(place(packed, 2.0 * random_point(random)));
        all.normals.push_back(glm::vec3(random_direction(random)));
    }
    return all;
}

// light_probability of every light, for one receiver.
std::vector<float> probabilities(const Program& program, const PackedScene& packed,
                                 const glm::vec3& point, const glm::vec3& normal) {
    const Device& d = test_device();
    const std::size_t count = packed.lights.lights.size();
    Buffer<float> out(d, count);
    const std::vector<float> in = {point.x, point.y, point.z, normal.x, normal.y, normal.z};
    run_probe(program, "light_probabilities", count, Buffer<LobeLight>(d, packed.lights.lights),
              Buffer<LobeLightNode>(d, packed.lights.nodes), static_cast<cl_uint>(count),
              static_cast<cl_uint>(packed.lights.root), Buffer<float>(d, in), out);
    return out.read_all();
}

Program light_program() {
    return build_probe("probe/light.cl", {{"lobe_scene.h", scene_header(all_features(), {})}});
}

// Whether a point of the light, chosen by two numbers, lights the receiver.
bool reaches(const PackedScene& packed, const LobeLight& light, const glm::dvec3& point,
             const glm::dvec3& normal, double u, double v) {
    const glm::dvec3 at(light.x, light.y, light.z);
    if (light.kind == LOBE_LIGHT_DISTANT) return glm::dot(at, normal) > 1e-5;
    if (light.kind == LOBE_LIGHT_POINT) return glm::dot(at - point, normal) > 1e-5;
    if (light.kind == LOBE_LIGHT_SPHERE)
        return glm::dot(at - point, normal) + light.radius > 1e-5 && light.radius > 0;
    const LobeTriangle& t = packed.triangles[light.primitive];
    const auto corner = [&](LobeUint i) {
        const LobeVertex& p = packed.vertices[i];
        return glm::dvec3(p.px, p.py, p.pz);
    };
    const glm::dvec3 a = corner(t.v0), e1 = corner(t.v1) - a, e2 = corner(t.v2) - a;
    if (u + v > 1) return reaches(packed, light, point, normal, 1 - u, 1 - v);
    const glm::dvec3 away = a + u * e1 + v * e2 - point;
    double leaving = -glm::dot(away, glm::normalize(glm::cross(e1, e2)));
    if (light.flags & LOBE_LIGHT_FLIPPED) leaving = -leaving;
    if (light.flags & LOBE_LIGHT_TWO_SIDED) leaving = std::fabs(leaving);
    return leaving > 1e-5 && glm::dot(away, normal) > 1e-5;
}

}  // namespace

// No probability is zero where a light reaches. They add up to one, or to less where bounds of
// several lights promised what none of them brings.
TEST(LightChoice, LeavesOutNoLight) {
    const Program program = light_program();
    Random random(31);
    for (const int lights : {2, 7, 60, 3000}) {
        const PackedScene packed = pack_scene(many_lights(lights, lights));
        const Receivers receivers = random_receivers(packed, 60, 77);
        int lit = 0, some = 0;
        double total = 0;
        for (std::size_t r = 0; r < receivers.points.size(); ++r) {
            const glm::vec3 &point = receivers.points[r], &normal = receivers.normals[r];
            const std::vector<float> p = probabilities(program, packed, point, normal);
            double sum = 0;
            for (const float q : p) sum += q;
            ASSERT_LT(sum, 1 + 2e-5) << lights << " lights";
            total += sum;
            some += sum > 0;
            for (std::size_t i = 0; i < p.size(); ++i) {
                for (int k = 0; k < 8; ++k) {
                    const double u = random.uniform(), v = random.uniform();
                    if (!reaches(packed, packed.lights.lights[i], point, normal, u, v)) continue;
                    ++lit;
                    ASSERT_GT(p[i], 0) << lights << " lights, receiver " << r << ", light " << i;
                }
            }
        }
        EXPECT_GT(lit, 50);
        EXPECT_GT(total, 0.6 * some) << lights << " lights";
    }
}

// A light is chosen as often as its probability says, and told the same both ways.
TEST(LightChoice, FollowsItsProbability) {
    const Program program = light_program();
    for (const int lights : {2, 7, 60, 600}) {
        const PackedScene packed = pack_scene(many_lights(lights, 100 + lights));
        const Receivers receivers = random_receivers(packed, 4, 5);
        const auto& all = packed.lights;
        for (std::size_t r = 0; r < receivers.points.size(); ++r) {
            const glm::vec3 &at = receivers.points[r], &n = receivers.normals[r];
            Random random(9 + r);
            std::vector<float> in;
            for (int i = 0; i < samples; ++i)
                in.insert(in.end(), {at.x, at.y, at.z, n.x, n.y, n.z, random.uniform_float()});
            const Device& d = test_device();
            Buffer<cl_uint> chosen(d, samples);
            Buffer<float> told(d, 2 * samples);
            run_probe(program, "light_choose", samples, Buffer<LobeLight>(d, all.lights),
                      Buffer<LobeLightNode>(d, all.nodes), static_cast<cl_uint>(all.lights.size()),
                      static_cast<cl_uint>(all.root), Buffer<float>(d, in), chosen, told);
            const std::vector<float> p = probabilities(program, packed, at, n);
            const std::vector<cl_uint> c = chosen.read_all();
            const std::vector<float> t = told.read_all();
            std::vector<double> counts(p.size() + 1), expected;  // and of no light
            for (int i = 0; i < samples; ++i) {
                ++counts[t[2 * i] < 0 ? p.size() : c[i]];
                if (t[2 * i] < 0) continue;
                ASSERT_NEAR(t[2 * i], p[c[i]], 1e-5 * p[c[i]]);
                ASSERT_NEAR(t[2 * i + 1], p[c[i]], 1e-5 * p[c[i]]);
            }
            double sum = 0;
            for (const float q : p) {
                expected.push_back(q * samples);
                sum += q;
            }
            expected.push_back(std::max(0.0, 1 - sum) * samples);
            EXPECT_TRUE(follows(counts, expected, 16)) << lights << " lights, receiver " << r;
        }
    }
}

// What is not lit for certain gets no sample: a floor under lights that look away.
TEST(LightChoice, SendsForNoLightThatCannotReach) {
    Scene scene = small_scene(0.5);
    for (int i = 0; i < 20; ++i)
        shine(add(scene, rectangle(glm::dvec3(0.3 * i, 0, 2), {0.1, 0, 0}, {0, 0.1, 0})), 1);
    const PackedScene packed = pack_scene(scene);  // they shine towards +z
    const Program program = light_program();
    for (const float q : probabilities(program, packed, place(packed, {0, 0, 0}), {0, 0, 1}))
        EXPECT_EQ(q, 0);
    for (const float q : probabilities(program, packed, place(packed, {0, 0, 3}), {0, 0, 1}))
        EXPECT_EQ(q, 0);
    double sum = 0;
    for (const float q : probabilities(program, packed, place(packed, {0, 0, 3}), {0, 0, -1}))
        sum += q;
    EXPECT_NEAR(sum, 1, 1e-5);
}
