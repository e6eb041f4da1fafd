// SPDX-License-Identifier: Apache-2.0
// Fresnel reflectance against the complex amplitudes in long double.
#include <gtest/gtest.h>

#include <complex>

#include "support/oracle.h"
#include "support/probe.h"
#include "base/random.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// |r|^2 averaged over both polarisations, from the amplitudes for an index eta + i k.
Long reflectance(Long cosine, Long eta, Long k) {
    const std::complex<Long> index(eta, k);
    const std::complex<Long> inside = std::sqrt(index * index - (1 - cosine) * (1 + cosine));
    const auto across = (cosine - inside) / (cosine + inside);
    const auto along = (index * index * cosine - inside) / (index * index * cosine + inside);
    return (std::norm(across) + std::norm(along)) / 2;
}

std::vector<float> conductor(const Program& program, const std::vector<float>& cosine,
                             const std::vector<float>& eta, const std::vector<float>& k) {
    Buffer<float> out(test_device(), cosine.size());
    run_probe(program, "math_fresnel_conductor", cosine.size(),
              Buffer<float>(test_device(), cosine), Buffer<float>(test_device(), eta),
              Buffer<float>(test_device(), k), out);
    return out.read_all();
}

std::vector<float> dielectric(const Program& program, const std::vector<float>& cosine,
                              const std::vector<float>& eta) {
    Buffer<float> out(test_device(), cosine.size());
    run_probe(program, "math_fresnel_dielectric", cosine.size(),
              Buffer<float>(test_device(), cosine), Buffer<float>(test_device(), eta), out);
    return out.read_all();
}

}  // namespace

TEST(Fresnel, ConductorAgainstComplexAmplitudes) {
    const Program program = build_probe("probe/math.cl");
    Random random(4);
    std::vector<float> cosine, eta, k;
    for (int i = 0; i < 100000; ++i) {
        cosine.push_back(float(i % 2 ? random.uniform() : random.log_uniform(1e-10, 1)));
        eta.push_back(float(random.log_uniform(1e-2, 1e2)));
        k.push_back(float(random.log_uniform(1e-3, 1e2)));
    }
    const std::vector<float> f = conductor(program, cosine, eta, k);
    double worst = 0;
    for (std::size_t i = 0; i < f.size(); ++i)
        worst = std::max(worst, std::fabs(double(f[i] - reflectance(cosine[i], eta[i], k[i]))));
    std::printf("  conductor: largest error %.2e\n", worst);
    EXPECT_LT(worst, 1e-5);  // at eta = 1, k = 0.001, where the root itself is ill-conditioned
    // No light lost at grazing angles; nothing undefined without contrast or without an index.
    const std::vector<float> corners =
        conductor(program, {0, 1e-38f, 1, 1, 1e-38f, 1}, {0.2f, 0.2f, 1, 0, 1, 1e4f},
                  {3.9f, 3.9f, 0, 0, 0, 1e4f});
    for (float value : corners) EXPECT_TRUE(value >= 0 && value <= 1) << value;
    EXPECT_EQ(corners[0], 1);
    EXPECT_EQ(corners[1], 1);
    EXPECT_EQ(corners[2], 0);
}

TEST(Fresnel, DielectricAgainstRealAmplitudes) {
    const Program program = build_probe("probe/math.cl");
    Random random(5);
    std::vector<float> cosine, eta;
    for (int i = 0; i < 100000; ++i) {
        cosine.push_back(float(random.uniform()));
        eta.push_back(float(random.log_uniform(0.2, 5)));
    }
    const std::vector<float> f = dielectric(program, cosine, eta);
    double worst = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
        const Long n2 = Long(eta[i]) * eta[i], c2 = Long(cosine[i]) * cosine[i];
        if (std::fabs(double(n2 - 1 + c2)) < 1e-2) continue;  // the critical angle: a square root
        worst = std::max(worst, std::fabs(double(f[i] - reflectance(cosine[i], eta[i], 0))));
    }
    std::printf("  dielectric: largest error %.2e\n", worst);
    EXPECT_LT(worst, 1e-5);
    EXPECT_EQ(dielectric(program, {1, 0.3f, 0, 0.5f}, {1, 1, 1.5f, 1 / 1.5f}),
              (std::vector<float>{0, 0, 1, 1}));
    EXPECT_NEAR(dielectric(program, {1}, {1.5f})[0], 0.04, 1e-8);
}
