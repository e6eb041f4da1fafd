// SPDX-License-Identifier: Apache-2.0
// The float build of each model against the double build of the same source, on the same inputs.
#include <gtest/gtest.h>

#include "kernel/brdf_probe.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

struct Difference {
    double f = 0, pdf = 0, weight = 0, direction = 0;
};

// Worst relative differences over random directions, half of them near the mirror direction.
Difference compare(const ModelProbe<float>& single, const ModelProbe<double>& wide,
                   const BrdfValues& values, Long width) {
    Random random(41);
    std::vector<vec3l> wo, wi, u;
    while (wo.size() < 8192) {
        const glm::vec3 o(
            direction(std::acos(Long(random.uniform(1e-3, 1))), random.uniform(0, 6.28)));
        const vec3l mirror(-o.x, -o.y, o.z);
        const glm::vec3 v(
            wo.size() % 2
                ? direction(std::acos(Long(random.uniform(1e-3, 1))), random.uniform(0, 6.28))
                : glm::normalize(mirror +
                                 width * Long(random.uniform(0, 4)) *
                                     direction(random.uniform(0, 3.1), random.uniform(0, 6.28))));
        if (!(v.z > 1e-3f)) continue;
        wo.push_back(vec3l(o));
        wi.push_back(vec3l(v));
        u.push_back({random.uniform_float(), random.uniform_float(), random.uniform_float()});
    }
    const auto a = single.eval({values}, wo, wi), b = wide.eval({values}, wo, wi);
    const auto s = single.sample({values}, wo, u), t = wide.sample({values}, wo, u);
    Difference worst;
    for (std::size_t i = 0; i < wo.size(); ++i) {
        // Compared with the peak of cos^n what underflows is nothing.
        worst.f = std::max(worst.f, std::fabs(a[i].f.x - b[i].f.x) / (b[i].f.x + 1e-20));
        worst.pdf = std::max(worst.pdf, std::fabs(a[i].pdf - b[i].pdf) / (b[i].pdf + 1e-20));
        if (s[i].delta != t[i].delta || s[i].pdf == 0 || t[i].pdf == 0) continue;
        const double apart = glm::length(s[i].wi - t[i].wi);
        if (apart > 0.1) continue;  // u.z fell between two roundings of the choice
        worst.direction = std::max(worst.direction, apart);
        if (t[i].wi.z > 0.1)
            worst.weight = std::max(
                worst.weight, std::fabs(s[i].weight.x - t[i].weight.x) / (t[i].weight.x + 1e-20));
    }
    return worst;
}

void report(const std::string& model, const BrdfValues& values, const Difference& d) {
    std::printf("  %-15s", model.c_str());
    for (const auto& [name, value] : values) std::printf(" %s %g", name.c_str(), value);
    std::printf(": f %.1e, pdf %.1e, weight %.1e, direction %.1e\n", d.f, d.pdf, d.weight,
                d.direction);
}

}  // namespace

TEST(BrdfDouble, PhongTypeModels) {
    LOBE_NEEDS_DOUBLE();
    for (const char* model : {"rational", "modified_phong", "phong"}) {
        const ModelProbe<float> single(model);
        const ModelProbe<double> wide(model);
        for (double n : {0.0, .05, .3, 1.0, 10.0, 100.0, 1e4, 1e6, 1e8}) {
            const BrdfValues values = {{"kd", .05}, {"ks", .5}, {"n", n}, {"normalize", 1}};
            const Difference d = compare(single, wide, values, std::min(.5, 1 / std::sqrt(n + 1)));
            report(model, values, d);
            // x of given vectors is nearly exact; n x in the exponent costs up to 87 roundings.
            EXPECT_LE(d.f, 1e-5) << model << " " << n;
            EXPECT_LE(d.pdf, 1e-5) << model << " " << n;
            EXPECT_LE(d.weight, 1e-4) << model << " " << n;
            EXPECT_LE(d.direction, 3e-5) << model << " " << n;
        }
    }
}

TEST(BrdfDouble, Microfacets) {
    LOBE_NEEDS_DOUBLE();
    const ModelProbe<float> plastic("plastic"), conductor("conductor");
    const ModelProbe<double> wide_plastic("plastic"), wide_conductor("conductor");
    for (double alpha : {.001, .01, .1, 1.0}) {
        Difference d = compare(plastic, wide_plastic, {{"alpha", alpha}}, alpha);
        report("plastic", {{"alpha", alpha}}, d);
        EXPECT_LE(d.f, 5e-6) << alpha;
        EXPECT_LE(d.pdf, 5e-6) << alpha;
        d = compare(conductor, wide_conductor, {{"alpha_x", alpha}, {"alpha_y", .3}}, alpha);
        report("conductor", {{"alpha_x", alpha}}, d);
        EXPECT_LE(d.f, 5e-6) << alpha;
        EXPECT_LE(d.weight, 2e-4) << alpha;
    }
}
