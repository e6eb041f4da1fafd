// SPDX-License-Identifier: Apache-2.0
// Reciprocity: kept to the last bits where it is claimed, and visibly broken by Phong's model and
// by the listing's reading of the rational one.
#include <gtest/gtest.h>

#include "kernel/brdf_probe.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Pairs of directions, half of them near one another's mirror direction, many of them grazing.
void pairs(std::vector<vec3l>& a, std::vector<vec3l>& b, std::size_t count) {
    Random random(11);
    while (a.size() < count) {
        const Long z = random.uniform() < 0.3 ? random.log_uniform(1e-6, 1) : random.uniform();
        const vec3l first = direction(std::acos(z), random.uniform(0, 6.28));
        vec3l second = direction(std::acos(Long(random.uniform())), random.uniform(0, 6.28));
        if (a.size() % 2) {
            const Long spread = random.log_uniform(1e-8, 1);
            second = glm::normalize(
                vec3l(-first.x, -first.y, first.z) +
                spread * direction(random.uniform(0, 3.14), random.uniform(0, 6.28)));
        }
        // What the device sees are floats: the pair must be the same floats both ways round.
        const vec3l u(glm::vec3{first}), v(glm::vec3{second});
        if (!(u.z > 0 && v.z > 0)) continue;
        a.push_back(u);
        b.push_back(v);
    }
}

// The largest relative difference of f(a, b) and f(b, a).
double asymmetry(const ModelProbe<float>& probe, const BrdfValues& values) {
    std::vector<vec3l> a, b;
    pairs(a, b, 20000);
    const auto ab = probe.eval({values}, a, b), ba = probe.eval({values}, b, a);
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double f = ab[i].f.x / static_cast<double>(b[i].z),
                     g = ba[i].f.x / static_cast<double>(a[i].z);
        if (std::max(f, g) < 1e-25) continue;
        worst = std::max(worst, std::fabs(f - g) / std::max(f, g));
    }
    return worst;
}

}  // namespace

TEST(BrdfSymmetry, ReciprocalWhereClaimed) {
    const ModelProbe<float> rational("rational"), modified("modified_phong");
    for (double n : {0.0, 0.3, 1.0, 10.0, 1e3, 1e6, 1e10, 3e38})
        for (double normalize : {0, 1}) {
            const BrdfValues values = {
                {"kd", 0.1}, {"ks", 0.5}, {"n", n}, {"normalize", normalize}};
            EXPECT_LE(asymmetry(modified, values), 1e-6) << n;
            for (double lobe : {0, 1}) {
                BrdfValues with = values;
                with.push_back({"lobe", lobe});
                EXPECT_LE(asymmetry(rational, with), 1e-6) << n << " lobe " << lobe;
            }
        }
    EXPECT_LE(asymmetry(ModelProbe<float>("lambert"), {}), 1e-6);
    const ModelProbe<float> plastic("plastic"), conductor("conductor");
    for (double alpha : {0.001, 0.1, 1.0}) {
        EXPECT_LE(asymmetry(plastic, {{"alpha", alpha}}), 4e-6) << alpha;
        EXPECT_LE(asymmetry(conductor, {{"alpha_x", alpha}, {"alpha_y", 0.5}}), 4e-6) << alpha;
    }
}

TEST(BrdfSymmetry, PhongAndListingAreNotReciprocal) {
    EXPECT_GT(asymmetry(ModelProbe<float>("phong"), {{"n", 10}}), 0.9);
    EXPECT_GT(asymmetry(ModelProbe<float>("rational"), {{"n", 10}, {"kd", 0}, {"lobe", 2}}), 0.9);
    // What Phong's model reflects, f cos theta_i, is symmetric instead.
    std::vector<vec3l> a, b;
    pairs(a, b, 20000);
    const ModelProbe<float> phong("phong");
    const BrdfValues values = {{"kd", 0}, {"n", 10}};
    const auto ab = phong.eval({values}, a, b), ba = phong.eval({values}, b, a);
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(ab[i].f.x, ba[i].f.x);
}
