// SPDX-License-Identifier: Apache-2.0
// The pixel filters as the kernel samples them: moments, normalisation, negative lobes.
#include <gtest/gtest.h>

#include <cmath>

#include "support/camera_rig.h"
#include "support/oracle.h"
#include "base/random.h"
#include "support/scenes.h"

using namespace lobe;
using namespace lobe::test;

namespace {

struct Named {
    const char* name;
    Filter filter;
};

const std::vector<Named> filters = {
    {"box", {FilterKind::box, 0.5, 0.5}},
    {"wide box", {FilterKind::box, 2, 1}},
    {"triangle", {FilterKind::triangle, 2, 1.5}},
    {"gaussian", {FilterKind::gaussian, 2, 2, 2}},
    {"sharp gaussian", {FilterKind::gaussian, 1.5, 3, 8}},
    {"mitchell", {FilterKind::mitchell, 2, 2, 2, 1.0 / 3, 1.0 / 3}},
    {"b-spline", {FilterKind::mitchell, 2, 2, 2, 1, 0}},
    {"catmull-rom", {FilterKind::mitchell, 2, 1.5, 2, 0, 0.5}},
};

// Moment of a filter along one axis over its integral.
double moment(const Filter& filter, double radius, int power) {
    // Piecewise smooth, with a joint in the middle of each half.
    const auto integral = [&](int k) {
        Long sum = 0;
        for (int part = 0; part < 2; ++part)
            sum += integrate(
                [&](Long x) {
                    return std::pow(x, k) * Long(filter_value(filter, radius, double(x)));
                },
                part * radius / 2, (part + 1) * radius / 2);
        return sum;
    };
    return double(integral(power) / integral(0));
}

constexpr int steps = 1 << 17;  // resolve the borders of the lobes to 3e-5

// Film numbers that step along one axis, at the middle of the other (where no filter is negative).
std::vector<CameraNumbers> line(int axis) {
    std::vector<CameraNumbers> all;
    for (int i = 0; i < steps; ++i) {
        const float u = (i + 0.5f) / steps;
        all.push_back({axis ? 0.5f : u, axis ? u : 0.5f, 0, 0});
    }
    return all;
}

CameraRig rig_of(const Filter& filter) {
    Scene scene = small_scene(0.5, 64);
    scene.filter = filter;
    return CameraRig(scene);
}

}  // namespace

TEST(FilterSampling, MomentsAreTheFilters) {
    for (const auto& [name, filter] : filters) {
        const CameraRig rig = rig_of(filter);
        double normalisation = 1 / tabulate_filter(filter).weight;
        for (int axis = 0; axis < 2; ++axis) {
            const double radius = axis ? filter.radius_y : filter.radius_x;
            double sums[5] = {};
            for (const CameraSample& s : rig.sample({30, 20}, line(axis))) {
                const double offset = axis ? s.film.y - 20.5 : s.film.x - 30.5;
                ASSERT_LE(std::abs(offset), radius * (1 + 1e-6)) << name;
                for (int k = 0; k <= 4; ++k) sums[k] += s.weight * std::pow(offset / radius, k);
            }
            normalisation *= sums[0] / steps;
            EXPECT_NEAR(sums[1] / sums[0], 0, 1e-5) << name;  // a ramp keeps its value
            EXPECT_NEAR(sums[3] / sums[0], 0, 1e-5) << name;
            for (const int k : {2, 4})
                EXPECT_NEAR(sums[k] / sums[0], moment(filter, radius, k) / std::pow(radius, k),
                            1e-4)
                    << name << ", axis " << axis << ", moment " << k;
        }
        EXPECT_NEAR(normalisation, 1, 4e-5) << name;
    }
}

// Weights have one size; their sign is the sign of the filter where the sample lies.
TEST(FilterSampling, NegativeLobesWeighNegative) {
    for (const auto& [name, filter] : filters) {
        std::size_t negative = 0, wrong = 0;
        const double size = tabulate_filter(filter).weight;
        const CameraRig rig = rig_of(filter);
        Random random(3);
        std::vector<CameraNumbers> numbers;
        for (int i = 0; i < 20000; ++i)
            numbers.push_back({random.uniform_float(), random.uniform_float(), 0, 0});
        for (const CameraSample& s : rig.sample({30, 20}, numbers)) {
            const double value = filter_value(filter, filter.radius_x, s.film.x - 30.5) *
                                 filter_value(filter, filter.radius_y, s.film.y - 20.5);
            ASSERT_FLOAT_EQ(std::abs(s.weight), float(size)) << name;
            negative += s.weight < 0;
            wrong += std::abs(value) > 1e-4 && (value < 0) != (s.weight < 0);
        }
        EXPECT_EQ(wrong, 0u) << name;
        const bool lobes = std::string(name) == "mitchell" || std::string(name) == "catmull-rom";
        EXPECT_EQ(negative > 0, lobes) << name;
    }
}

// The distribution itself, not only its moments: as much of |f| lies left of any sample as the
// number that made it says.
TEST(FilterSampling, SamplesInvertTheDistribution) {
    for (const auto& [name, filter] : filters) {
        Random random(1);
        std::vector<CameraNumbers> numbers;
        for (int i = 0; i < 500; ++i) numbers.push_back({random.uniform_float(), 0.5f, 0, 0});
        const auto samples = rig_of(filter).sample({30, 20}, numbers);
        const double radius = filter.radius_x;
        constexpr int cells = 20000;
        std::vector<double> sum = {0};
        for (int i = 0; i < cells; ++i)
            sum.push_back(sum.back() + std::abs(filter_value(
                                           filter, radius, radius * (2 * (i + 0.5) / cells - 1))));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double at = ((samples[i].film.x - 30.5) / radius + 1) / 2 * cells;
            const double part = sum[std::size_t(std::min(at, double(cells)))] / sum.back();
            ASSERT_NEAR(part, numbers[i][0], 1e-3) << name << " at " << samples[i].film.x - 30.5;
        }
    }
}
