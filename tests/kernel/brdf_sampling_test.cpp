// SPDX-License-Identifier: Apache-2.0
// For every model: samples follow the density, the density integrates to what is sampled, and the
// mean weight is the albedo that quadrature finds.
#include <gtest/gtest.h>

#include "base/statistics.h"
#include "kernel/brdf_grid.h"
#include "kernel/brdf_probe.h"
#include "support/chi_square.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

struct Case {
    std::string model;
    BrdfValues values;
};

std::vector<Case> cases() {
    std::vector<Case> all = {{"lambert", {}}};
    for (double n : {0.0, 0.02, 0.1, 0.5, 1 - 1e-6, 1.0, 2.0, 10.0, 100.0, 1e4, 1e6})
        all.push_back({"rational", {{"n", n}, {"ks", 0.5}, {"kd", 0.1}, {"normalize", 1}}});
    for (double n : {0.0, 0.5, 100.0})
        all.push_back(
            {"rational", {{"n", n}, {"ks", 0.8}, {"kd", 0}, {"normalize", 1}, {"lobe", 1}}});
    all.push_back({"rational", {{"n", 10}, {"lobe", 2}}});
    for (const char* model : {"phong", "modified_phong"})
        for (double n : {0.0, 0.5, 2.0, 10.0, 100.0, 1e4, 1e6})
            all.push_back({model, {{"n", n}, {"ks", 0.5}, {"kd", 0.1}, {"normalize", 1}}});
    for (double alpha : {0.03, 0.3, 1.0}) all.push_back({"plastic", {{"alpha", alpha}}});
    all.push_back({"plastic", {{"alpha", 0.2}, {"eta", 1 / 1.5}, {"kd", 0}}});
    all.push_back({"conductor", {{"alpha_x", 0.3}, {"alpha_y", 0.3}}});
    all.push_back({"conductor", {{"alpha_x", 0.05}, {"alpha_y", 0.4}}});
    all.push_back({"conductor", {{"alpha_x", 0.02}, {"alpha_y", 0.02}}});
    return all;
}

constexpr double angles[] = {0.05, 45, 80, 89.5};
const double tests = 2.0 * 4 * static_cast<double>(cases().size());  // chi-square and mean each

std::vector<BrdfSampled> draw(const ModelProbe<float>& probe, const Case& c, const vec3l& wo,
                              std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<vec3l> u(count);
    for (vec3l& v : u) v = {random.uniform_float(), random.uniform_float(), random.uniform_float()};
    return probe.sample({c.values}, std::vector<vec3l>(count, wo), u);
}

// Rings that each hold about as many samples of a pilot, which is not used again, and finer ones
// between a sharp lobe and what surrounds it.
std::vector<Long> pilot_rings(const std::vector<BrdfSampled>& pilot, const vec3l& wo) {
    std::vector<Long> x, edges = {0.25L, 0.5L, 0.75L, 1, 1.25L, 1.5L, 1.75L};
    for (const BrdfSampled& s : pilot) {
        const vec3l d = vec3l(-wo.x, -wo.y, wo.z) - vec3l(s.wi);
        if (s.pdf > 0) x.push_back(0.5L * glm::dot(d, d));
    }
    std::sort(x.begin(), x.end());
    for (int i = 1; i < 20; ++i) edges.push_back(x[x.size() * i / 20]);
    for (Long tail = x[x.size() / 200]; tail < 0.25L; tail *= 2) edges.push_back(tail);
    return edges;
}

void check(const ModelProbe<float>& probe, const Case& c, double degrees, std::uint64_t seed) {
    // The float direction itself is the viewer's, so that the grid's horizon is the device's.
    const vec3l wo(glm::vec3(direction(radians(degrees))));
    constexpr std::size_t count = 100000;
    // At grazing angles reflection by facets is far narrower across than along.
    const int azimuths = c.model == "conductor" || c.model == "plastic" ? 32 : 6;
    const HemisphereGrid grid(wo, pilot_rings(draw(probe, c, wo, 10000, seed + 1), wo), azimuths);
    const auto values =
        probe.eval({c.values}, std::vector<vec3l>(grid.nodes.size(), wo), grid.nodes);
    std::vector<double> expected(grid.cells() + 1), counts(grid.cells() + 1);
    double mass = 0, albedo = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double w = static_cast<double>(grid.weights[i]);
        expected[grid.node_cells[i]] += count * values[i].pdf * w;
        mass += values[i].pdf * w;
        albedo += values[i].f.x * w;
    }
    std::vector<double> weights;
    for (const BrdfSampled& s : draw(probe, c, wo, count, seed)) {
        ++counts[s.pdf > 0 ? grid.cell_of(vec3l(s.wi)) : grid.cells()];
        weights.push_back(s.weight.x);
    }
    const double lost = counts.back() / count;
    expected.back() = std::max(0.0, count * (1 - mass));
    EXPECT_TRUE(follows(counts, expected, tests));
    EXPECT_LE(mass, 1 + 2e-4);
    EXPECT_NEAR(mass, 1 - lost, 2e-4 + 5 * std::sqrt(lost / count));
    // Where all weights are equal, rounding is what is left.
    const double error = std::hypot(standard_error(weights), 2e-4 * albedo / 4);
    EXPECT_TRUE(normal_deviate((mean(weights) - albedo) / error, tests))
        << "albedo " << albedo << ", mean weight " << mean(weights);
}

void check_model(const std::string& model) {
    const ModelProbe<float> probe(model);
    std::uint64_t seed = 100;
    for (const Case& c : cases()) {
        ++seed;
        if (c.model != model) continue;
        for (const double degrees : angles) {
            std::string text = model + " at " + std::to_string(degrees) + " degrees:";
            for (const auto& [name, value] : c.values)
                text += " " + name + " " + std::to_string(value);
            SCOPED_TRACE(text);
            check(probe, c, degrees, seed * 1000 + static_cast<int>(degrees));
        }
    }
}

}  // namespace

TEST(BrdfSampling, Lambert) { check_model("lambert"); }
TEST(BrdfSampling, Rational) { check_model("rational"); }
TEST(BrdfSampling, Phong) { check_model("phong"); }
TEST(BrdfSampling, ModifiedPhong) { check_model("modified_phong"); }
TEST(BrdfSampling, Plastic) { check_model("plastic"); }
TEST(BrdfSampling, Conductor) { check_model("conductor"); }

// The weight is f cos / pdf, and the density that the sample carries is the one that pdf gives for
// its direction, up to the rounding of that direction: n d 2^-24 at an angle d from the peak.
TEST(BrdfSampling, WeightIsValueOverDensity) {
    for (const char* model :
         {"lambert", "rational", "phong", "modified_phong", "plastic", "conductor"}) {
        const ModelProbe<float> probe(model);
        std::uint64_t seed = 7000;
        for (const Case& c : cases()) {
            ++seed;
            if (c.model != model) continue;
            double n = 100;
            for (const auto& [name, value] : c.values) {
                if (name == "n") n = value;
                if (name == "alpha" || name == "alpha_x") n = 1 / (value * value);
            }
            const double tolerance = 2e-5 + 8 * std::sqrt(n) * 0x1p-24;
            for (const double degrees : angles) {
                const vec3l wo = direction(radians(degrees));
                const auto samples = draw(probe, c, wo, 4096, seed);
                std::vector<vec3l> wi;
                for (const auto& s : samples) wi.push_back(vec3l(s.wi));
                const auto values = probe.eval({c.values}, std::vector<vec3l>(wi.size(), wo), wi);
                for (std::size_t i = 0; i < samples.size(); ++i) {
                    if (samples[i].pdf == 0 || samples[i].wi.z < 1e-3) continue;
                    ASSERT_NEAR(samples[i].pdf / values[i].pdf, 1, tolerance * 10)
                        << model << " n " << n << " at " << degrees << " z " << samples[i].wi.z;
                    ASSERT_NEAR(samples[i].weight.x * samples[i].pdf / values[i].f.x, 1,
                                tolerance * 10)
                        << model << " n " << n << " at " << degrees;
                }
            }
        }
    }
}
