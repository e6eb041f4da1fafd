// SPDX-License-Identifier: Apache-2.0
// The ends of all ranges: whatever the parameters, directions and random numbers, a model gives
// finite values, and either a sound sample or none.
#include <gtest/gtest.h>

#include "kernel/brdf_probe.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const double ns[] = {0, 1e-30, 1e-6, .05, .5,   1 - 0x1p-24, 1,       1 + 0x1p-23,
                     2, 10,    1e4,  1e8, 1e12, 3e38,        INFINITY};
const double albedos[][2] = {{0, 0}, {.25, 0}, {0, .5}, {.1, .5}};  // kd, ks

std::vector<BrdfValues> phong_sets(bool rational) {
    std::vector<BrdfValues> sets;
    for (const double n : ns)
        for (const auto& a : albedos)
            for (double normalize : {0, 1})
                for (double lobe : {0, 1, 2}) {
                    BrdfValues set = {
                        {"kd", a[0]}, {"ks", a[1]}, {"n", n}, {"normalize", normalize}};
                    if (rational) set.push_back({"lobe", lobe});
                    if (rational || lobe == 0) sets.push_back(set);
                }
    return sets;
}

std::vector<BrdfValues> facet_sets(bool conductor) {
    std::vector<BrdfValues> sets;
    for (double a : {0.0, 1e-6, 1e-3, 1.1e-3, .1, 1.0, 10.0})
        for (double b : {0.0, 1e-4, .2, 1.0, 10.0}) {
            if (conductor) {
                for (double k : {0.0, 1e-3, 4.0, 1e4})
                    sets.push_back({{"alpha_x", a}, {"alpha_y", b}, {"eta", b}, {"k", k}});
            } else {
                sets.push_back({{"alpha", a}, {"eta", std::max(b, .1)}, {"kd", 0}});
                sets.push_back({{"alpha", a}, {"eta", 1}, {"kd", 0}, {"ks", b}});
            }
        }
    return sets;
}

const double cosines[] = {1, 1 - 0x1p-24, .7, .05, 1e-3, 1e-7, 1e-20, 1e-37};

// With each direction its exact mirror image: half vectors of opposite grazing ones underflow.
std::vector<vec3l> directions() {
    std::vector<vec3l> all;
    for (const double z : cosines)
        for (double phi : {0.0, 2.5}) {
            const Long r = std::sqrt((1 - Long(z)) * (1 + Long(z)));
            all.push_back({r * std::cos(Long(phi)), r * std::sin(Long(phi)), z});
            all.push_back({-all.back().x, -all.back().y, z});
        }
    return all;
}

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool sound(const BrdfSampled& s) {
    if (!finite(s.wi) || !finite(s.weight) || !std::isfinite(s.pdf)) return false;
    if (s.pdf == 0) return s.weight == glm::dvec3(0);
    return s.pdf > 0 && s.weight.x >= 0 && s.wi.z > 0 && std::fabs(glm::length(s.wi) - 1) < 2e-6;
}

std::string describe(const BrdfValues& set, const vec3l& a, const vec3l& b) {
    std::string text;
    for (const auto& [name, value] : set) text += name + " " + std::to_string(value) + " ";
    char numbers[200];
    std::snprintf(numbers, sizeof numbers, "(%.9Lg %.9Lg %.9Lg) (%.9Lg %.9Lg %.9Lg)", a.x, a.y, a.z,
                  b.x, b.y, b.z);
    return text + numbers;
}

void check(const std::string& model, const std::vector<BrdfValues>& sets) {
    const ModelProbe<float> probe(model);
    EXPECT_LE(probe.prepared_bytes(), 512u);
    std::vector<vec3l> wo, wi, u;
    const Long corners[] = {0, 0x1p-24L, .0999L, .5L, 1 - 0x1p-24L};
    std::size_t per_set = 0;
    for (const BrdfValues& set : sets) {
        (void)set;
        for (const vec3l& o : directions())
            for (const Long x : corners)
                for (const Long y : corners)
                    for (const Long z : {corners[0], corners[3], corners[4]})
                        wo.push_back(o), u.push_back({x, y, z});
        if (!per_set) per_set = wo.size();
    }
    const auto samples = probe.sample(sets, wo, u);
    int shown = 0;
    for (std::size_t i = 0; i < samples.size() && shown < 5; ++i)
        if (!sound(samples[i])) {
            ADD_FAILURE() << "sample of " << model << " "
                          << describe(sets[i / per_set], wo[i], u[i]) << " pdf " << samples[i].pdf
                          << " weight " << samples[i].weight.x << " wi " << samples[i].wi.x << " "
                          << samples[i].wi.y << " " << samples[i].wi.z;
            ++shown;
        }
    wo.clear();
    for (std::size_t set = 0; set < sets.size(); ++set)
        for (const vec3l& o : directions())
            for (const vec3l& v : directions()) wo.push_back(o), wi.push_back(v);
    const auto values = probe.eval(sets, wo, wi);
    per_set = wo.size() / sets.size();
    for (std::size_t i = 0; i < values.size() && shown < 5; ++i)
        if (!(finite(values[i].f) && values[i].f.x >= 0 && std::isfinite(values[i].pdf) &&
              values[i].pdf >= 0)) {
            ADD_FAILURE() << "value of " << model << " "
                          << describe(sets[i / per_set], wo[i], wi[i]) << " f " << values[i].f.x
                          << " pdf " << values[i].pdf;
            ++shown;
        }
}

}  // namespace

TEST(BrdfExtremes, Lambert) { check("lambert", {{{"kd", 0}}, {{"kd", .3}}}); }
TEST(BrdfExtremes, Mirror) { check("mirror", {{{"kr", 0}}, {{"kr", .9}}}); }
TEST(BrdfExtremes, Rational) { check("rational", phong_sets(true)); }
TEST(BrdfExtremes, Phong) { check("phong", phong_sets(false)); }
TEST(BrdfExtremes, ModifiedPhong) { check("modified_phong", phong_sets(false)); }
TEST(BrdfExtremes, Plastic) { check("plastic", facet_sets(false)); }
TEST(BrdfExtremes, Conductor) { check("conductor", facet_sets(true)); }

// n = infinity, normalised: a mirror of the stated reflectance beside the diffuse part.
TEST(BrdfExtremes, InfiniteSharpnessIsAMirror) {
    for (const char* model : {"rational", "modified_phong", "phong"}) {
        const ModelProbe<float> probe(model);
        const vec3l wo = direction(radians(60));
        const BrdfValues values = {{"kd", .2}, {"ks", .5}, {"n", INFINITY}, {"normalize", 1}};
        const double reflectance = std::string(model) == "phong" ? .5 : .25;  // ks cos theta
        const auto s = probe.sample({values}, {wo, wo}, {vec3l(.3, .3, 0), vec3l(.3, .3, .999)});
        EXPECT_TRUE(s[0].delta) << model;
        EXPECT_NEAR(s[0].weight.x * s[0].pdf, reflectance, 1e-6) << model;
        EXPECT_EQ(s[0].wi.x, static_cast<float>(-wo.x));
        EXPECT_FALSE(s[1].delta) << model;
        EXPECT_NEAR(s[1].weight.x * (1 - s[0].pdf), .2, 1e-6) << model;
        const auto value = probe.eval({values}, {wo}, {vec3l(-wo.x, -wo.y, wo.z)})[0];
        EXPECT_NEAR(value.f.x, .2 / 3.14159265 * .5, 1e-6) << model;  // the mirror is not seen here
        // Without normalisation the lobe has vanished.
        const BrdfValues raw = {{"kd", 0}, {"ks", .5}, {"n", INFINITY}};
        EXPECT_EQ(probe.sample({raw}, {wo}, {vec3l(.3, .3, 0)})[0].weight.x, 0) << model;
    }
}

// Every sample of the arc is above the horizon; only rounding at its very end may lose one.
TEST(BrdfExtremes, VisibleArcWastesNoSample) {
    for (const char* model : {"rational", "modified_phong", "phong"}) {
        const ModelProbe<float> probe(model);
        Random random(31);
        std::vector<vec3l> wo, u;
        for (int i = 0; i < 200000; ++i) {
            wo.push_back(
                direction(std::acos(Long(random.log_uniform(1e-6, 1))), random.uniform(0, 6.28)));
            u.push_back({random.uniform_float(), random.uniform_float(), random.uniform_float()});
        }
        for (double n : {0.0, 1.0, 100.0, 1e6}) {
            int lost = 0;
            for (const auto& s : probe.sample({{{"kd", 0}, {"ks", 1}, {"n", n}}}, wo, u))
                lost += s.pdf == 0;
            EXPECT_LE(lost, 4) << model << " n " << n;
        }
    }
}
